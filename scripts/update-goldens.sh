#!/usr/bin/env bash
# Draws the pictures of tests/golden/ again with the desktop build. Look at every picture that changes (git diff --stat lists
# them) before you commit it, and tell in the message why it changed.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --build --preset desktop
VCT_TEST_ALL=1 VCT_UPDATE_GOLDENS=1 build/desktop/tests/vct_tests --gtest_filter='*Golden*'
git status --short tests/golden
