#!/bin/sh
# yosys_read.sh TOP FILE...: fails unless Yosys reads TOP. It warns only of a name that nobody
# declared and of bits left undriven (as it leaves them for some legal SystemVerilog): fatal here.
# TOP may set parameters: 'unit -chparam Width 4'.
set -eu
top=$1
shift
exec yosys -q -e 'implicitly declared' -e 'has no driver' -e '[Ll]atch inferred' -f 'verilog -sv' \
  -p "hierarchy -check -top $top; proc; check -assert" "$@"
