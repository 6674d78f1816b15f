"""How the light behaves over frames: swimming, lag and noise. tools/motion.py is the command line."""
