"""Mitsuba 3 and its one variant.

`llvm_ad_rgb`: references must be the same bytes when they are made again, so there is one variant and no fallback.
It wants LLVM 19: with Debian 12's LLVM 15 it stops at "Cannot select", and it refuses 14.
"""
import glob
import os
import sys

VARIANT = "llvm_ad_rgb"
LIBRARIES = ("/usr/lib/*/libLLVM.so.19*", "/usr/lib/*/libLLVM-19.so*", "/usr/lib/llvm-19/lib/libLLVM.so*")


def find_llvm() -> str:
    for pattern in LIBRARIES:
        found = sorted(glob.glob(pattern))
        if found:
            return found[0]
    sys.exit("error: LLVM 19 is not installed, and path tracing needs it: run scripts/python.sh, "
             "or name the library in DRJIT_LIBLLVM_PATH")


def load():
    """The module `mitsuba`, ready for use."""
    os.environ.setdefault("DRJIT_LIBLLVM_PATH", "") or os.environ.update(DRJIT_LIBLLVM_PATH=find_llvm())
    import mitsuba
    if mitsuba.variant() != VARIANT:
        mitsuba.set_variant(VARIANT)
    return mitsuba
