#!/bin/sh
# refuses.sh PATTERN COMMAND...: passes when COMMAND fails and says PATTERN. Each check is run so on a
# mutant, to prove that it can fail, and for the right reason.
pattern=$1
shift
if output=$("$@" 2>&1); then
  echo "accepted what it must refuse: $*"
  exit 1
fi
printf '%s\n' "$output" | grep -qE -e "$pattern" && exit 0
echo "failed, but without saying '$pattern':"
printf '%s\n' "$output"
exit 1
