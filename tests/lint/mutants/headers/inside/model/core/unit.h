/// A unit.
///
/// Bits     the definition. Twin     rtl/unit.sv.
void setup();
class TileWalk;
