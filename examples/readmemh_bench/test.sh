#!/bin/sh
# test.sh PINEDA VECTORS RTL: run.sh holds, and a changed bit of a stamp is found with its case.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sh "$(dirname "$0")/run.sh" "$@" "$work"
cd "$work"
sed '1000s/[02468ace]$/1/; t; 1000s/.$/0/' stamp.hex > changed.hex
if cmp -s stamp.hex changed.hex; then echo "no bit was changed" >&2; exit 1; fi
mv changed.hex stamp.hex
if found=$(build/Vtraversal_bench 2>&1); then echo "a changed stamp holds" >&2; exit 1; fi
echo "$found" | grep "^case [0-9]*, stamp [0-9]* at "
