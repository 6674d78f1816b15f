"""What the shaders cost on Arm Mali, by the panfrost compiler's counts. tools/mali.py is the command line."""
