"""A phone that is connected by adb, and the app on it (tools/phone.py)."""
