// A depth code from a plane's value and the bias.
//
// Bits     core::interpolate_depth() defines them: one rounding of the sum, halves up, and a clamp.
// In       value_i and bias_i, both s<DEPTH_BITS+2>, each with its fraction.
// Out      code_o in the same cycle.
// Twin     model/core/interp.cpp.
`ifdef PINEDA_DEPTH
module depth_code (
  input  logic signed [pineda_pkg::DEPTH_TILE_PLANE_BITS-1:0] value_i,
  input  logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0]       bias_i,
  output logic        [pineda_pkg::DEPTH_BITS-1:0]            code_o
);
  localparam int unsigned OUT_BITS = pineda_pkg::DEPTH_BITS;
  // Value and bias are added with the fraction of the finer one.
  localparam int unsigned PLANE_FRACTION = pineda_pkg::TILE_FRACTION_BITS;
  localparam int unsigned BIAS_FRACTION = pineda_pkg::BIAS_FRACTION_BITS;
  localparam int unsigned F = PLANE_FRACTION > BIAS_FRACTION ? PLANE_FRACTION : BIAS_FRACTION;
  localparam int unsigned SUM_BITS = OUT_BITS + 3 + F;
  localparam int unsigned ROUNDED_BITS = OUT_BITS + 4;

  logic signed [SUM_BITS-1:0] sum;
  logic signed [ROUNDED_BITS-1:0] rounded;
  assign sum = (SUM_BITS'(value_i) <<< (F - PLANE_FRACTION)) +
               (SUM_BITS'(bias_i) <<< (F - BIAS_FRACTION));
  assign rounded = ROUNDED_BITS'(signed'(sum[SUM_BITS-1:F])) +
                   ROUNDED_BITS'(signed'({1'b0, sum[F-1]}));
  always_comb begin
    if (rounded < 0) code_o = '0;
    else if (rounded[ROUNDED_BITS-1:OUT_BITS] != '0) code_o = '1;
    else code_o = rounded[OUT_BITS-1:0];
  end
endmodule
`endif
