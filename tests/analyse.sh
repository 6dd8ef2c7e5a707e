#!/bin/sh
# Reads every source with clang-tidy, cppcheck and gcc -fanalyzer; the exit
# status is that of a grep for findings.  From the root, with the packages
# clang, clang-tidy and cppcheck; about ten minutes.
set -eu
cd "$(dirname "$0")/.."
build=build-analyse
found=$build/found
rooms='lib/core lib/friction lib/scene lib/fit lib/store lib/plot
       lib/interchange manifold portrait lib/study lib/race apps'

# gcc 12 knows neither vectors nor arrays filled in loops, and takes what a
# grown array holds for lost.
[ -e $build ] || CFLAGS="-fanalyzer -Wno-analyzer-use-of-uninitialized-value
    -Wno-analyzer-shift-count-overflow -Wno-analyzer-malloc-leak
    -Wno-error" meson setup $build -Dtests=disabled -Doptimization=2
ninja -C $build clean
ninja -C $build apps/slipway >$found 2>&1

for room in $rooms; do
    ls "$room"/*.c
done | xargs clang-tidy --quiet -p $build --extra-arg=-Wno-unknown-warning-option \
    --extra-arg=-fno-analyzer 2>/dev/null >>$found || true

# Across files cppcheck takes an array to be filled for one not yet filled.
cppcheck -q --std=c11 --enable=warning,performance,portability -D_GNU_SOURCE \
    --suppress=ctuArrayIndex --suppress=ctuuninitvar --suppress=uninitvar \
    --suppress=legacyUninitvar --suppress=uninitStructMember \
    --suppress=internalAstError --suppress=invalidPointerCast \
    --suppress=memleak:lib/study/baseline.c --inline-suppr \
    $(for room in $rooms; do printf -- '-I%s ' "$room"; done) $rooms 2>>$found

! grep -E '(warning|error):' $found
