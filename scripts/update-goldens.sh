#!/usr/bin/env bash
# Remakes tests/golden/ with the desktop build. Look at every picture that changes (git diff --stat shows which)
# before you commit it, and say in the message why it changed.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --build --preset desktop
VCT_UPDATE_GOLDENS=1 build/desktop/tests/vct_tests --gtest_filter='*Golden*'
git status --short tests/golden
