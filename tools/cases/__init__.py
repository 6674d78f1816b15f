"""The hard cases of the truth: what is asked of vct, the right answer, and how far off it is."""

from .case import Case, Measured, run_case, table

__all__ = ["Case", "Measured", "run_case", "table"]
