#!/bin/sh
# Reads every source with clang-tidy, cppcheck and gcc -fanalyzer; prints what
# they find and succeeds where that is nothing.  From anywhere, with the
# packages clang, clang-tidy and cppcheck; about ten minutes.
set -eu
cd "$(dirname "$0")/.."
build=build-analyse
found=$build/found
rooms="$(ls -d lib/*/*.c | xargs -n 1 dirname | sort -u) manifold portrait apps"

# gcc 12 knows neither vectors nor arrays filled in loops, takes what a grown
# array holds for lost, and does not see that of two conditions one holds only
# where the other does: clang's analyzer looks for null pointers, and tests let
# every allocation fail.
[ -e $build ] || CFLAGS="-fanalyzer -Wno-analyzer-use-of-uninitialized-value
    -Wno-analyzer-shift-count-overflow -Wno-analyzer-malloc-leak
    -Wno-analyzer-null-dereference -Wno-analyzer-possible-null-dereference
    -Wno-analyzer-null-argument -Wno-error" \
    meson setup $build -Dtests=disabled -Doptimization=2
ninja -C $build clean
ninja -C $build apps/slipway >$found 2>&1

# The same without what clang does not know.  It fails over what it finds, so
# that it starts at all is asked first.
clang-tidy --version >/dev/null
mkdir -p $build/clang
sed 's/ -fanalyzer//; s/ -Wno-analyzer[a-z-]*//g' \
    $build/compile_commands.json >$build/clang/compile_commands.json
for room in $rooms; do
    ls "$room"/*.c
done | xargs -n 8 -P "$(nproc)" clang-tidy --quiet -p $build/clang \
    2>/dev/null >>$found || true

# Across files cppcheck takes an array to be filled for one not yet filled, and
# a call REAL(ln)(x) of a name made by a macro for a cast.
cppcheck -q --std=c11 --enable=warning,performance,portability -D_GNU_SOURCE \
    --suppress=ctuArrayIndex --suppress=ctuuninitvar --suppress=uninitvar \
    --suppress=legacyUninitvar --suppress=uninitStructMember \
    --suppress=internalAstError --suppress=invalidPointerCast \
    --suppress=constStatement:lib/friction/field_formula.h \
    $(for room in $rooms; do printf -- '-I%s ' "$room"; done) $rooms 2>>$found

! grep -E '(warning|error):' $found
