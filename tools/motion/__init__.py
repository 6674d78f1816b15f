"""How the light behaves over frames: swimming, lag and noise, convergence. tools/motion.py is the command line."""
