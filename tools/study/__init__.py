"""The known defects of the published implementation, one experiment each. tools/defects.py is the command line."""
