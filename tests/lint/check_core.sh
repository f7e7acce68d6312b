#!/bin/sh
# check_core.sh CORE: model/core must stay plain: no vectors, attributes, builtins, reinterpreting
# casts or threads; no file over 250 lines, 1,900 lines in all.
set -eu
cd "$1"
bad=0
if grep -nE '__builtin|__attribute__|\[\[gnu|vector_size|target_clones|#pragma [^o]|immintrin|<thread>|<atomic>|memcpy|reinterpret_cast|offsetof|\basm\b' -- *.h *.cpp; then
  echo "check_core.sh: the definition is to be plain" >&2
  bad=1
fi
total=0
for file in *.h *.cpp; do
  lines=$(wc -l <"$file")
  total=$((total + lines))
  if [ "$lines" -gt 250 ]; then
    echo "$file: $lines lines, at most 250" >&2
    bad=1
  fi
done
if [ "$total" -gt 1900 ]; then
  echo "$total lines, at most 1900" >&2
  bad=1
fi
[ "$bad" -eq 0 ] && echo "$total lines"
