#!/bin/sh
# run.sh PINEDA VECTORS RTL [DIR]: exports traversal vectors as memories, builds traversal_bench.sv around the
# traversal unit of the folder RTL, and runs it without stalls and with them. In DIR, or in a folder that is removed.
set -eu
pineda=$1 vectors=$2 rtl=$(cd "$3" && pwd)
bench=$(cd "$(dirname "$0")" && pwd)
if [ $# -gt 3 ]; then
  work=$4
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
"$pineda" vectors export "$vectors" --readmemh -o "$work"
cd "$work"
verilator --binary --timing --assert -Wall -Wno-UNUSEDPARAM --Mdir build --top-module traversal_bench -I. \
  "$rtl/pineda_pkg.sv" "$rtl/lib/stream_fifo.sv" "$rtl"/traversal/*.sv "$rtl/lint/waivers.vlt" \
  "$bench/traversal_bench.sv" -MAKEFLAGS "OPT_FAST=-O1 OPT_SLOW=-O0 OPT_GLOBAL=-O0" > build.log 2>&1 || {
  cat build.log >&2
  exit 1
}
build/Vtraversal_bench
build/Vtraversal_bench +stalls
