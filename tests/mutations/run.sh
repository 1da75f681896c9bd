#!/usr/bin/env bash
# Shows that the tests see: applies each mutation of mutations.json in a scratch copy and expects its tests to fail.
#   bash tests/mutations/run.sh                 all of them
#   bash tests/mutations/run.sh NAME...         those whose name contains one of the words given
#   bash tests/mutations/run.sh --check         only: does every mutation still find its place?
# Exit 1 when a mutation is missed or its place is gone. REYE_MUTATIONS names a scratch folder to keep and reuse: a
# run that was interrupted then continues with what is left, as long as the tree stays the same.
set -euo pipefail
exec python3 "$(dirname "${BASH_SOURCE[0]}")/run.py" "$@"
