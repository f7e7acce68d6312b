#!/bin/sh
# check_hygiene.sh ROOT: fails when a file holds a path of somebody's machine, a mark of unfinished
# work, or a conflict mark. (The brackets keep the patterns from finding themselves.)
cd "$1" || exit 1
pattern='(^|[^A-Za-z0-9_.}*-])/(wor[k]|tm[p]|hom[e]|roo[t]|mn[t]|User[s])/'
pattern="$pattern|\\<(TOD[O]|FIXM[E]|XX[X])\\>|^[<]{7} |^[>]{7} "
found=$(find . \( -name .git -o -name 'build*' -o -path ./out -o -name mutants \) -prune \
  -o -type f -exec grep -nIHE "$pattern" {} +)
[ -z "$found" ] && exit 0
printf '%s\n' "$found"
exit 1
