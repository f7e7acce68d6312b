#!/bin/sh
# check_waivers.sh FILE...: fails unless each waiver names a rule, a file and a match, and stands
# under a comment with the reason (waivers in a row may share it). A whole rule may be waived in a
# file, without a match, under a comment of its own.
set -eu
awk '
function refuse(why) {
  printf "%s:%d: %s: %s\n", FILENAME, FNR, why, $0
  bad = 1
}
FNR == 1 { above = "" }
/^`verilator_config$/ { above = ""; next }
/^\/\/ / { above = "reason"; next }
/^public_/ { if (above == "") refuse("no reason above"); next }
/^lint_off / {
  ++waivers
  if ($0 !~ / -rule [A-Z]+ -file "\*\/[a-z_]+\.sv"/) refuse("names no rule or no one file")
  else if ($0 !~ / -match "[^"]*[a-z][^"]*"$/ && above != "reason") {
    refuse("no match, and no reason of its own")
  } else if (above == "") refuse("no reason above")
  above = "waiver"
  next
}
{ refuse("neither a waiver nor a reason") }
END {
  if (waivers == 0) { print "no waiver found"; exit 1 }
  printf "%d waivers\n", waivers
  exit bad
}' "$@"
