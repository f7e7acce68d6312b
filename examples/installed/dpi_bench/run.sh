#!/bin/sh
# run.sh PREFIX [DIR]: the bench on the RTL of an installed pineda; then on a copy with a bug, which must be found.
set -eu
prefix=$(cd "$1" && pwd)
bench=$(cd "$(dirname "$0")" && pwd) dpi=$prefix/share/pineda/dpi
mkdir -p "${2:-dpi_bench}"
cd "${2:-dpi_bench}"

build() {  # RTL NAME
  verilator --binary --timing --assert --trace-fst -Wall -Wno-UNUSEDPARAM -Wno-UNUSEDSIGNAL --Mdir "$2" \
    --top-module dpi_bench "$1/pineda_pkg.sv" "$dpi/pineda_dpi_pkg.sv" $(sed "1d; s|^|$1/|" "$1/files.f") \
    "$1/lint/waivers.vlt" "$dpi/stream_rules.sv" "$bench/dpi_bench.sv" "$dpi/pineda_dpi.c" -CFLAGS "-I$prefix/include" \
    -LDFLAGS "-L$prefix/lib -Wl,-rpath,$prefix/lib -lpineda_golden" \
    -MAKEFLAGS "OPT_FAST=-O1 OPT_SLOW=-O0 OPT_GLOBAL=-O0" > "$2.log" 2>&1 || { cat "$2.log" >&2; exit 1; }
}
build "$prefix/share/pineda/rtl" right
for seed in 1 2 3; do right/Vdpi_bench +seed=$seed; done
right/Vdpi_bench +stall=0

cp -r "$prefix/share/pineda/rtl" rtl
sed -i 's/top_left = dy < 0 || .*;/top_left = dy < 0;/' rtl/setup/setup_edges.sv  # top edges lose their samples
build rtl wrong
if wrong/Vdpi_bench +trace=bug.fst > bug.log 2>&1; then echo "the bug was not found"; exit 1; fi
grep -m 1 'expected' bug.log
ls bug.fst
