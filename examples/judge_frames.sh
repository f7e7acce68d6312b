#!/bin/sh
# judge_frames.sh PINEDA DEPTH_ULP "SCENE..." DRAW...: runs DRAW SCENE DIR for each scene and judges the frame in
# DIR. Exit code 1 at the first one that does not hold.
set -eu
pineda=$1 depth_ulp=$2 scenes=$3
shift 3
frame=$(mktemp -d)
trap 'rm -rf "$frame"' EXIT
for scene in $scenes; do
  "$@" "$scene" "$frame"
  "$pineda" judge "$scene" --dump "$frame" --depth-ulp "$depth_ulp"
done
