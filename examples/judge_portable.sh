#!/bin/sh
# judge_portable.sh PINEDA FRAMES LACKS DRAW...: makes portable cases of a file of frame vectors, runs DRAW SCENE DIR
# for each of them, and judges all frames. Cases with a line that LACKS matches, an extended regular expression, are
# left out: what the rasterizer does not have. The judge counts them.
set -eu
pineda=$1 frames=$2 lacks=$3
shift 3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$pineda" vectors export "$frames" --portable -o "$work/cases.txt"
"$pineda" vectors export "$work/cases.txt" --tri -o "$work/scenes" --quiet
for scene in $(grep -LE "$lacks" "$work"/scenes/*.tri); do
  name=${scene##*/}
  "$@" "$scene" "$work/frames/${name%.tri}"
done
"$pineda" judge --portable "$work/cases.txt" --dump "$work/frames" --drawn-only
