"""The report: one self-contained page from a sweep. tools/report.py is its command line."""
