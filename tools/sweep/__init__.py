"""The sweep: settings x scenes x drivers -> times and errors. tools/sweep.py is its command line."""
