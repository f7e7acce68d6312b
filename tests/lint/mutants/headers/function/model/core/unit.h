/// A unit.
///
/// Bits     the definition.
/// Twin     rtl/unit.sv.
void set_up();
class TileWalk;
