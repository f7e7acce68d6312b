// A unit.
//
// Bits     StampWalk defines them.
// Twin     model/core/unit.h.
module unit;
endmodule
