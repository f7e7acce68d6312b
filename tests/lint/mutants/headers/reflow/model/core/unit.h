/// A unit.
///
/// Bits     the definition of every bit, and of
/// those that wrap.
/// Twin     rtl/unit.sv.
void setup();
class TileWalk;
