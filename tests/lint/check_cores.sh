#!/bin/sh
# check_cores.sh FOLDER: every path that a FuseSoC .core file below the folder names is there, and one beside a
# files.f names its sources in that order.
set -eu
cd "$1"
bad=0
refuse() {
  echo "$1: $2" >&2
  bad=1
}
# The items of `files:` lists.
paths() {
  awk '/^ *files:/ { inside = 1; next } inside && /^ *- / { sub(/^ *- /, ""); sub(/:.*/, ""); print; next }
       { inside = 0 }' "$1"
}
cores=$(find . -name '*.core' | sed 's|^\./||' | sort)
[ -n "$cores" ] || refuse "$1" "no .core file"
for core in $cores; do
  folder=$(dirname "$core")
  [ "$(head -n 1 "$core")" = CAPI=2: ] || refuse "$core" "expected CAPI=2: in the first line"
  [ -n "$(paths "$core")" ] || refuse "$core" "no files"
  for path in $(paths "$core"); do
    [ -f "$folder/$path" ] || refuse "$core" "no file $path"
  done
  [ -f "$folder/files.f" ] || continue
  [ "$(paths "$core" | grep '\.sv$')" = "$(cat "$folder/files.f")" ] || refuse "$core" "other sources than files.f"
done
[ "$bad" -eq 0 ] && echo "$(echo "$cores" | wc -l) cores"
