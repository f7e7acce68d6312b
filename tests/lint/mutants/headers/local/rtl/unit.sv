// A unit.
//
// Bits     gradient() in model/core/unit.h.
// Twin     model/core/unit.h.
module unit;
endmodule
