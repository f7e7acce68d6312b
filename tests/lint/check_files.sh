#!/bin/sh
# check_files.sh RTL: RTL/files.f names each synthesizable source of the folder once, the package first.
# None has a memory of structs, which Yosys 0.23 drops without a word.
set -eu
cd "$1"
bad=0
refuse() {
  echo "files.f: $1" >&2
  bad=1
}
[ "$(head -n 1 files.f)" = pineda_pkg.sv ] || refuse "the package does not come first"
while read -r file; do
  [ -f "$file" ] || refuse "$file is not in the folder"
done <files.f
for file in $(find . -name '*.sv' -not -path './formal/*' | sed 's|^\./||' | sort); do
  [ "$(grep -cxF "$file" files.f)" -eq 1 ] || refuse "$file is not in files.f once"
done
if grep -nE '^ *([a-z_]+::)?[a-z_]+_t +[a-z_0-9]+ +\[' $(cat files.f) >&2; then
  refuse "expected memories of plain vectors, got one of structs"
fi
[ "$bad" -eq 0 ] && echo "$(wc -l <files.f) files"
