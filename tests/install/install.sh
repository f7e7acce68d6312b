#!/bin/sh
# install.sh CMAKE BUILD MOVED: installs a build tree into a prefix beside MOVED, and moves it there.
set -eu
rm -rf "$3" "$3.first"
"$1" --install "$2" --prefix "$3.first" >/dev/null
mv "$3.first" "$3"
# A name of an own header in C would be ambiguous.
[ "$(find "$3/include" -name '*golden*.h')" = "$3/include/pineda/golden.h" ]
[ -z "$(find "$3" -type d -empty)" ]
