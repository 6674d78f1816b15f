"""Mitsuba 3, `mi`, and its compiler Dr.Jit, `dr`, in the one variant.

References must be the same bytes when they are made again, so there is one variant, `llvm_ad_rgb`, and no fallback. It needs
LLVM 19: with Debian 12's LLVM 15 it stops at "Cannot select", and it refuses 14.
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


if not os.environ.get("DRJIT_LIBLLVM_PATH"):
    os.environ["DRJIT_LIBLLVM_PATH"] = find_llvm()

import mitsuba as mi  # noqa: E402  (after the library is known)

mi.set_variant(VARIANT)

import drjit as dr  # noqa: E402, F401  (after the variant is known)
