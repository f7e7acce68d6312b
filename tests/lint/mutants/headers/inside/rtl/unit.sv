// A unit.
//
// Bits     core::setup() defines them.
// Twin     model/core/unit.h.
module unit;
endmodule
