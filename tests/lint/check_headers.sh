#!/bin/sh
# check_headers.sh ROOT: fails when a labelled header comment names what is not there, or lost its form.
#   Bits, Twin       every file, NS::NAME, NAME() and CamelCase name in them exists: where the label
#                    names a file, in the code of that file; else in model/NS or anywhere in model
#   every label      stands at the start of its line; the lines that go on with it are indented; labels
#                    come in the order Bits, In, Out, Rate, Drops, Errors, Twin, Source
set -eu
cd "$1"
find . \( -name '.?*' -o -name 'build*' -o -name out -o -name mutants -o -name tests \) -prune \
  -o \( -name '*.cpp' -o -name '*.h' -o -name '*.sv' \) -print | sed 's|^\./||' | sort | xargs awk '
BEGIN {
  labels = split("Bits In Out Rate Drops Errors Twin Source", label)
  for (i = 1; i <= labels; ++i) place[label[i]] = i
}
function refuse(why) {
  print why
  bad = 1
}
function close_label() {
  if (text != "") {
    ++named
    where[named] = begun
    said[named] = text
  }
  text = ""
}
function close_comment() {
  close_label()
  inside = last = 0
}
# The words of a line of code: these are the names that a header may use.
function learn(line, part, n, i, folder) {
  split(FILENAME, folder, "/")
  n = split(line, part, /[^A-Za-z0-9_]+/)
  for (i = 1; i <= n; ++i) {
    if (part[i] == "") continue
    in_file[FILENAME, part[i]] = 1
    if (folder[1] != "model") continue
    in_model[part[i]] = 1
    in_folder[folder[2], part[i]] = 1
    is_folder[folder[2]] = 1
  }
}
FNR == 1 { close_comment(); is_file[FILENAME] = 1; files++ }
!/^[ \t]*\/\/[\/ ]?/ {
  close_comment()
  code = $0
  sub(/\/\/.*/, "", code)
  learn(code)
  next
}
FILENAME !~ /\.(h|sv)$/ { next }
{
  at = FILENAME ":" FNR
  line = $0
  sub(/^[ \t]*\/\/\/?/, "", line)
  name = line
  sub(/^ /, "", name)
  sub(/[ ,].*/, "", name)
}
line ~ /^ *$/ { close_comment(); next }
line ~ /[^ ] +(Bits|In|Out|Rate|Drops|Errors|Twin|Source)   +[^ ]/ {
  refuse(at ": a label inside a line:" line)
}
line ~ /^ [A-Z][a-z]+(, [A-Z][a-z]+)?  / && name in place {
  close_label()
  if (place[name] <= last) refuse(at ": " name " comes too late")
  last = place[name]
  inside = 1
  if (name == "Bits" || name == "Twin") {
    begun = at
    text = line
  }
  ++seen
  next
}
inside && line !~ /^         / { refuse(at ": a label goes on without indentation:" line) }
text != "" { text = text " " line }
# What one label names: words of letters, digits, _ and what stands in paths, scopes and calls.
function check(id, part, n, i, word, file, named_file, ns, call) {
  sub(/ Source: .*/, "", said[id])
  n = split(said[id], part, /[^A-Za-z0-9_:\/.()]+/)
  named_file = ""
  for (i = 1; i <= n; ++i) {
    word = part[i]
    sub(/[.:]+$/, "", word)
    if (word ~ /^[a-z]+\/[a-z0-9_\/]+\.(sv|h|cpp|mk)$/) {
      if (!(word in is_file)) refuse(where[id] ": no file " word)
      named_file = named_file " " word
    }
  }
  for (i = 1; i <= n; ++i) {
    word = part[i]
    sub(/[.:]+$/, "", word)
    call = sub(/\(\)$/, "", word)
    if (word ~ /^[a-z]+::[A-Za-z0-9_]+$/) {
      ns = word
      sub(/::.*/, "", ns)
      sub(/.*::/, "", word)
      if (ns in is_folder && !((ns, word) in in_folder)) {
        refuse(where[id] ": no " word " in model/" ns)
      }
    } else if (call || word ~ /^[A-Z][a-z0-9]+[A-Z][A-Za-z0-9]*$/) {
      if (word !~ /^[A-Za-z0-9_]+$/) continue
      if (!found(word, named_file)) {
        refuse(where[id] ": no " word (named_file == "" ? " in model" : " in" named_file))
      }
    } else if (word ~ /^[A-Z][a-z]+$/ && part[i + 1] == "in" && part[i + 2] ~ /^model\//) {
      if (!found(word, named_file)) refuse(where[id] ": no " word " in" named_file)
    }
  }
}
function found(word, named_file, file, n, i) {
  if (named_file == "") return word in in_model
  n = split(named_file, file, " ")
  for (i = 1; i <= n; ++i) {
    if ((file[i], word) in in_file) return 1
  }
  return 0
}
END {
  close_comment()
  if (seen == 0) { print "no label found"; exit 1 }
  for (i = 1; i <= named; ++i) check(i)
  printf "%d labels in %d files\n", seen, files
  exit bad
}'
