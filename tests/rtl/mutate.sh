#!/bin/sh
# mutate.sh SOURCE EMIT FOLDER: a copy of the RTL with one fault in each unit and one in its
# counters, which that unit's suite must catch. EMIT is emit_package. Fails when a fault no longer
# finds its line.
set -eu
source=$1
emit=$2
folder=$3
rm -rf "$folder"
mkdir -p "$folder/tb"
cp -r "$source/rtl" "$folder/rtl"
cp "$source"/tb/plugin.* "$folder/tb/"

fault() {  # FILE SED-COMMAND
  sed "$2" "$folder/$1" > "$folder/mutated"
  if cmp -s "$folder/mutated" "$folder/$1"; then
    echo "mutate.sh: '$2' changes nothing in $1" >&2
    exit 1
  fi
  mv "$folder/mutated" "$folder/$1"
}

# Setup: every edge counts as top-left, so shared edges are hit twice.
fault rtl/setup/setup_edges.sv 's/top_left = dy < 0 .*;/top_left = dy < 0 || dx > 0 || dx <= 0;/'
# Traversal: a tile whose best corner lies just inside an edge is rejected.
fault rtl/traversal/tile_walker.sv 's/assign rejects\[i\] = best < 0;/assign rejects[i] = best <= 0;/'
# Depth test: less passes equal depths.
fault rtl/interp/interp_ztest_unit.sv "s/\(DEPTH_LESS: .*\)3'b100/\13'b110/"

# Top: the memories are always told to clear depth to the greatest code.
fault rtl/raster_top.sv "s/clear_depth_o = .*;/clear_depth_o = '1;/"

# Counters: coverage that waits is busy.
fault rtl/traversal/coverage_finder.sv 's/cycle_cause_pkg::BLOCKED/cycle_cause_pkg::BUSY/'

# Package: two fields of a tile change places. It is generated, so its generator is wrapped.
cat > "$folder/emit" <<WRAPPER
#!/bin/sh
"$emit" "\$@" || exit
sed -i '/u3 px/ { s/ x0;/ swap;/; s/ y0;/ x0;/; s/ swap;/ y0;/; }' "\$2/pineda_pkg.sv"
WRAPPER
chmod +x "$folder/emit"
