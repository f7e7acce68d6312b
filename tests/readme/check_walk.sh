#!/bin/sh
# check_walk.sh PROGRAM README: each line of the README's ```walk blocks must be a line that the
# program prints.
set -eu
program=$1
readme=$2
output=$("$program" walk triangle --stamp 10)
lines=$(sed -n '/^```walk$/,/^```$/ { /^```/d; p; }' "$readme")
[ -n "$lines" ] || { echo "check_walk.sh: $readme has no walk block" >&2; exit 1; }
missing=$(printf '%s\n' "$lines" | while IFS= read -r line; do
  printf '%s\n' "$output" | grep -qxF -- "$line" || printf '%s\n' "$line"
done)
[ -z "$missing" ] || { printf 'the program does not print:\n%s\n' "$missing" >&2; exit 1; }
