/// A unit.
///
/// Bits     those of StampWalk.
/// Twin     rtl/unit.sv.
void setup();
class TileWalk;
