"""The verbs of tools/eval.py, one module each, and what they share."""
