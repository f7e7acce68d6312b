#!/bin/sh
# refuses.sh PATTERN COMMAND...: passes when COMMAND fails and prints PATTERN. Each check is run
# this way on a mutant, to prove that it can fail, and for the right reason. 77: COMMAND skips its
# check.
pattern=$1
shift
output=$("$@" 2>&1)
status=$?
if [ "$status" -eq 77 ]; then
  printf '%s\n' "$output"
  exit 77
fi
if [ "$status" -eq 0 ]; then
  echo "accepted what it must refuse: $*"
  exit 1
fi
printf '%s\n' "$output" | grep -qE -e "$pattern" && exit 0
echo "failed, but without saying '$pattern':"
printf '%s\n' "$output"
exit 1
