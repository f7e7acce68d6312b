#!/bin/sh
# yosys_read.sh TOP FILE...: fails unless Yosys reads TOP without these warnings: a name that nobody
# declared, and undriven bits, which it also leaves for some legal SystemVerilog.
# TOP may set parameters: 'unit -chparam Width 4'.
set -eu
top=$1
shift
exec yosys -q -e 'implicitly declared' -e 'has no driver' -e '[Ll]atch inferred' -f 'verilog -sv' \
  -p "hierarchy -check -top $top; proc; check -assert" "$@"
