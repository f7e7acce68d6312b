/// A unit.
///
/// Twin     rtl/unit.sv.
/// Bits     the definition.
void setup();
class TileWalk;
