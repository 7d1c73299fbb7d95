#!/bin/sh
# HexFeatureWB - LGPL-2.1-or-later
# Run every fuzz target for so many seconds: tests/fuzz/run.sh SECONDS. A find ends its target and lies in build-fuzz/finds.
set -u
cd "$(dirname "$0")/../.."
mkdir -p build-fuzz/finds
failed=0
for target in options triangles brep step; do
  mkdir -p "build-fuzz/runs/$target"
  # OCCT keeps things for the life of the process: no leak check.
  ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=0 UBSAN_OPTIONS=print_stacktrace=1 \
    "build-fuzz/${target}_fuzz" "build-fuzz/runs/$target" "tests/fuzz/corpus/$target" -max_total_time="$1" -timeout=20 -rss_limit_mb=3000 \
    -max_len=20000 -artifact_prefix="build-fuzz/finds/$target-" >"build-fuzz/$target.log" 2>&1 || failed=1
  grep -E '^(SUMMARY|Done|ERROR|==.*ERROR)|runtime error' "build-fuzz/$target.log" | sed "s/^/$target: /" | head -5
done
exit $failed
