#!/usr/bin/env bash
# Builds everything and runs the tests. Arguments go to ctest: ./test.sh -R raster, ./test.sh -L unit
set -euo pipefail
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")"

scripts/setup.sh
exec ctest --preset release --no-tests=error -j"$(nproc)" "$@"
