#!/bin/sh
# check_symbols.sh LIBRARY HEADER: the library shows the calls of its header and nothing else, and needs no
# SystemC, no Verilator, no reader of pictures.
set -eu
shown=$(nm -D --defined-only "$1" | awk '{print $3}' | sed 's/@.*//' | sort)
declared=$(sed -n 's/^PINEDA_API .*\(pineda_[a-z0-9_]*\)(.*/\1/p' "$2" | sort)
[ -n "$declared" ] || { echo "no call declared in $2"; exit 1; }
if [ "$shown" != "$declared" ]; then
  echo "$1 shows other calls than $2 declares:"
  printf '%s\n%s\n' "$shown" "$declared" | sort | uniq -u
  exit 1
fi
needed=$(readelf -d "$1" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p')
for library in $needed; do
  case "$library" in
    libtomlplusplus* | libfmt* | libhwy.* | libstdc++* | libm.* | libgcc_s* | libc.* | ld-linux* | libdl.* | libpthread.*) ;;
    *) echo "$1 needs $library"; exit 1 ;;
  esac
done
echo "$(echo "$shown" | wc -l) calls, all declared"
