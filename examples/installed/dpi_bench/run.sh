#!/bin/sh
# run.sh PREFIX [DIR]: builds the bench with the RTL and the DPI package of an installed pineda, runs it, and
# runs it once more on a unit with a bug: that one must be found, and leaves a waveform.
set -eu
prefix=$(cd "$1" && pwd)
bench=$(cd "$(dirname "$0")" && pwd)
work=${2:-$(mktemp -d)}
mkdir -p "$work"
cd "$work"

build() {  # RTL NAME
  verilator --binary --timing --assert --trace-fst -Wall -Wno-UNUSEDPARAM -Wno-UNUSEDSIGNAL --Mdir "$2" \
    --top-module dpi_bench "$1/pineda_pkg.sv" "$prefix/share/pineda/dpi/pineda_dpi_pkg.sv" \
    $(sed -n "/pkg.sv/!s|^|$1/|p" "$1/files.f") "$1/lint/waivers.vlt" \
    "$prefix/share/pineda/dpi/stream_rules.sv" "$bench/dpi_bench.sv" "$prefix/share/pineda/dpi/pineda_dpi.c" \
    -CFLAGS "-I$prefix/include" -LDFLAGS "-L$prefix/lib -Wl,-rpath,$prefix/lib -lpineda_golden" \
    -MAKEFLAGS "OPT_FAST=-O1 OPT_SLOW=-O0 OPT_GLOBAL=-O0" > "$2.log" 2>&1 || { cat "$2.log" >&2; exit 1; }
}

build "$prefix/share/pineda/rtl" right
for seed in 1 2 3; do right/Vdpi_bench +seed=$seed; done
right/Vdpi_bench +stall=0

# Edges that are top edges no longer own the samples on them.
cp -r "$prefix/share/pineda/rtl" rtl
sed -i 's/top_left = dy < 0 || (dy == .0 && dx > 0);/top_left = dy < 0;/' rtl/setup/setup_edges.sv
! cmp -s rtl/setup/setup_edges.sv "$prefix/share/pineda/rtl/setup/setup_edges.sv"
build rtl wrong
if wrong/Vdpi_bench +trace=bug.fst > bug.log 2>&1; then
  echo "the bug was not found"
  exit 1
fi
grep -m 1 'expected' bug.log
ls bug.fst
