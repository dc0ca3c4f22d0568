#!/usr/bin/env bash
# Runs some tests of pictures on another kind of GL, or all of them with MOMENTSCOPE_THOROUGH=1.
# Usage: kind.sh GL_TEST NAME=VALUE..., with the variables that choose the kind.
set -euo pipefail
program=$1
shift
filter='KindOfGl.*:PeelingTest.ARegion*:LesserGl.TheCheckFindsTheBitsOfCpp:*BitEquality.*/power4_32'
[ "${MOMENTSCOPE_THOROUGH:-}" != 1 ] || filter='*'
exec env "$@" "$program" --gtest_brief=1 --gtest_filter="$filter"
