#!/bin/sh
# explain_frames.sh DRAW EXPLAIN "SCENE..." [FILE]: draws each scene with llvmpipe and prints how many of its
# samples are not exact, and how many of these its arithmetic does not explain. Exit code 1 if any is not. With
# FILE, the first byte of that file of the frame is changed beforehand. Exit code 77 where Mesa is another than
# the one that is explained.
set -eu
draw=$1 explain=$2 scenes=$3 file=${4:-}
version=$("$draw" --version)
case $version in
  *"Mesa 22.3."*) ;;
  *) echo "expected Mesa 22.3, whose arithmetic is explained, got: $version"; exit 77 ;;
esac
frame=$(mktemp -d)
trap 'rm -rf "$frame"' EXIT
bad=0
for scene in $scenes; do
  "$draw" "$scene" "$frame"
  if [ -n "$file" ]; then printf '\377' | dd of="$frame/$file" conv=notrunc status=none; fi
  "$explain" "$scene" "$frame" > "$frame/list" || bad=1
  echo "$scene: $(tail -n 1 "$frame/list")"
done
exit $bad
