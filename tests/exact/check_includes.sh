#!/bin/sh
# check_includes.sh FOLDER: fails when the judge includes a header of the project that is not its
# own: it must stay independent of what it judges.
found=$(grep -rnE '^[[:space:]]*#[[:space:]]*include' "$1" |
  grep -E '"|<(model|rtl|tb|cli|vectors|studies|tests)/' | grep -v '"model/exact/')
[ -z "$found" ] && exit 0
echo "the judge must include nothing of the project:"
echo "$found"
exit 1
