#!/bin/sh
# check_direction.sh ROOT: fails when an include points against the direction
#   spec <- core <- fast <- timing <- tb <- cli;  memory -> core;  scene, vectors -> figures -> spec;
#   judge -> core, exact; exact and files use nothing; bench -> cli, examples; tests use everything. What judges (vectors, tb)
#   compares with core and never sees fast.
# Also: paths start at the root, only the plug-ins of tb, the tests of lone modules and the foreign RTL see
# a Verilated header, and SystemC is known from model/timing on.
set -eu
cd "$1"
find . \( -name '.?*' -o -name 'build*' -o -name out -o -name mutants \) -prune \
  -o \( -name '*.cpp' -o -name '*.h' \) -print | sed 's|^\./||' | sort | xargs awk '
BEGIN {
  may["model/files"] = "model/files"
  may["model/spec"] = "model/spec"
  may["model/figures"] = "model/figures model/spec"
  may["model/core"] = "model/core model/spec"
  may["model/fast"] = "model/fast model/core model/spec"
  may["model/exact"] = "model/exact"
  may["model/scene"] = "model/scene model/figures model/files model/spec"
  may["model/judge"] = "model/judge model/core model/exact model/spec"
  may["model/baseline"] = "model/baseline model/spec"
  may["model/memory"] = "model/memory model/core model/spec"
  may["model/timing"] = "model/timing model/memory model/fast model/core model/spec"
  may["vectors"] = "vectors model/judge model/memory model/figures model/core model/exact model/files model/spec"
  may["tb"] = "tb model/timing model/memory model/core model/files model/spec"
  may["studies"] = "studies tb vectors model/timing model/memory model/scene model/baseline " \
                   "model/judge model/exact model/fast model/core model/figures model/files model/spec"
  may["golden"] = "golden studies model/scene model/judge model/exact model/fast model/core model/spec"
  may["cli"] = "cli " may["studies"]
  may["examples"] = "examples model/timing model/memory model/scene model/baseline model/judge model/core model/spec"
  may["bench"] = "bench examples cli model/scene model/fast model/spec"
  may["tests"] = "tests golden " may["cli"]
}
function folder(path, part) {
  split(path, part, "/")
  return part[1] == "model" ? part[1] "/" part[2] : part[1]
}
# They have headers generated beside them.
function plugs(file) {
  return file == "tb/plugin.cpp" || file == "tb/bench_plugin.cpp"
}
function verilates(file) {
  return plugs(file) || file == "examples/foreign_rtl/main.cpp" ||
         file ~ "^tests/rtl/(scheme|pipelined|setup|multiplier)_rtl_test.cpp$"
}
function refuse(why) {
  printf "%s:%d: %s: %s\n", FILENAME, FNR, why, $0
  bad = 1
}
/^[ \t]*#[ \t]*include[ \t]*[<"]/ {
  ++includes
  from = folder(FILENAME)
  name = $0
  sub(/^[^<"]*[<"]/, "", name)
  sub(/[>"].*/, "", name)
  to = folder(name)
  if (!(from in may)) {
    refuse("no rule for the folder " from)
  } else if (name ~ /^(verilated|V[a-z])/) {
    if (!verilates(FILENAME)) refuse("a Verilated header outside of the plug-ins")
  } else if (name ~ /^systemc/) {
    if (from !~ /^(model\/timing|tb|studies|cli|examples|tests)$/) refuse("SystemC below model/timing")
  } else if (to in may) {
    if (index(" " may[from] " ", " " to " ") == 0) refuse(from " may not include " to)
  } else if ($0 ~ /"/ && !plugs(FILENAME)) {
    refuse("not a path from the root")
  }
}
END {
  if (includes == 0) { print "no include found"; exit 1 }
  printf "%d includes\n", includes
  exit bad
}'
