/// A unit.
///
/// Bits     the definition.
/// Twin     rtl/setup/unit.sv.
void setup();
class TileWalk;
