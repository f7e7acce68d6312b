#!/bin/sh
# verilate_scheme.sh RTL TOP PACKAGE FOLDER VERILATOR [FAULT]: the module TOP as the archive
# FOLDER/V<name>__ALL.a, named after the folder. TOP may have parameters behind it, as Verilator takes
# them. FAULT is a sed command that makes a mutant; it must change a source.
set -eu
rtl=$1 top=$2 package=$3 folder=$4 verilator=$5
name=$(basename "$folder")
rm -rf "$folder"
mkdir -p "$folder/rtl"
cp "$rtl"/reciprocal/*.sv "$rtl"/setup/*.sv "$folder/rtl"
for module in booth_rows delay_line multiplier multiplier_pipelined; do
  cp "$rtl/lib/$module.sv" "$folder/rtl"
done
if [ $# -gt 5 ]; then
  sed -i "$6" "$folder"/rtl/*.sv
  changed=no
  for file in "$folder"/rtl/*.sv; do
    cmp -s "$file" "$rtl"/*/"$(basename "$file")" || changed=yes
  done
  if [ $changed = no ]; then
    echo "verilate_scheme.sh: '$6' changes nothing" >&2
    exit 1
  fi
fi
"$verilator" --cc -O3 --x-assign fast --x-initial fast ${VERILATOR_WARNINGS:--Wall} --prefix "V$name" \
  --Mdir "$folder" --top-module $top "$rtl/lint/waivers.vlt" "$package" "$folder"/rtl/*.sv
exec make -s -C "$folder" -f "V$name.mk" OPT_FAST=-O1 OPT_SLOW=-O0 "V${name}__ALL.a"
