#!/bin/sh
# HexFeatureWB - LGPL-2.1-or-later
# The sanitizer build (make sanitize) through the C++ tests, those Python tests that mesh, and parts: tests/sanitize.sh [OUT_DIR]
set -u
cd "$(dirname "$0")/.."
out=${1:-out/sanitize}
failed=0
ctest --preset sanitize --progress || failed=1
# Python is not sanitized itself: it must load the run-time library first. Python and OpenCASCADE keep things for the life of the process.
env LD_PRELOAD="$(gcc -print-file-name=libasan.so) $(gcc -print-file-name=libstdc++.so.6)" ASAN_OPTIONS=detect_leaks=0 \
  UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 HEXFEATURE_PACKAGE="$PWD/build-sanitize/python" \
  /usr/bin/python3 -m pytest -p no:cacheprovider -q tests/python/test_odd_parts.py tests/python/test_methods.py || failed=1
/usr/bin/python3 benchmarks/sanitize.py "$out" || failed=1
exit $failed
