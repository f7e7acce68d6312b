#!/bin/sh
# consumer.sh PREFIX: a program with the SystemC model and the RTL's benches of an installed tree; and that another
# C++ standard, or a component that does not exist, gets a sentence.
set -eu
source=$(cd "$(dirname "$0")/consumer" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CMAKE_PREFIX_PATH="$1"
cmake -S "$source" -B "$work/right" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cmake --build "$work/right" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
"$work/right/consumer"

says() {  # SENTENCE COMMAND...: the command fails and says so, over lines or not
  sentence=$1
  shift
  if "$@" >"$work/log" 2>&1; then echo "expected a failure: $*"; exit 1; fi
  tr -s ' \n' ' ' <"$work/log" | grep -q "$sentence" || { cat "$work/log"; exit 1; }
}
says "expected CMAKE_CXX_STANDARD 17, as pineda and its SystemC library were built with, got 20" \
  cmake -S "$source" -B "$work/wrong" -DCMAKE_CXX_STANDARD=20
says "expected C++17" c++ -std=c++20 -fsyntax-only -I"$1/include/pineda" "$source/main.cpp"
mkdir "$work/other"
cat > "$work/other/CMakeLists.txt" <<CMAKE
cmake_minimum_required(VERSION 3.22)
project(other LANGUAGES C)
find_package(pineda REQUIRED COMPONENTS silver)
CMAKE
says "expected components of golden;timing;tb, got 'silver'" cmake -S "$work/other" -B "$work/other/build"
