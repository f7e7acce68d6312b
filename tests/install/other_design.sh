#!/bin/sh
# other_design.sh PREFIX: a design that no plug-in was built of is verilated from the installed sources.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat > "$work/small.toml" <<TOML
base = "flat"
subpixel_bits = 5
guard_bits = 9
TOML
PINEDA_CACHE="$work/cache" CXXFLAGS=-O0 "$1/bin/pineda" check triangle --design "$work/small.toml"
ls "$work"/cache/small_*.so >/dev/null
