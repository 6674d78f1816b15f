"""The hard cases of the truth: what is asked of vct, the right answer, and how far off it is."""
