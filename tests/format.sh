#!/usr/bin/env bash
# Refuses sources that clang-format would write otherwise (.clang-format); 77, skipped, where it is not installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
command -v clang-format >/dev/null || exit 77
find src tests apps \( -name '*.hpp' -o -name '*.cpp' \) -print0 | xargs -0 clang-format --dry-run -Werror
