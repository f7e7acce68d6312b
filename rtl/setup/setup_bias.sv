// Depth bias: the slope term and the constant added, then saturated. No state.
//
// Bits     core::setup() defines the bias of its depth plane.
// In       slope_i: magnitude times slope factor, in units of 2^-16 codes.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_DEPTH
module setup_bias (
  input  pineda_pkg::frame_t                                                           frame_i,
  input  logic signed [pineda_pkg::BIAS_MAGNITUDE_BITS+pineda_pkg::BIAS_SLOPE_BITS:0]  slope_i,
  output logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0]                                bias_o
);
  localparam int unsigned BITS = pineda_pkg::DEPTH_BIAS_BITS;
  localparam int unsigned SUM_BITS =
      pineda_pkg::BIAS_MAGNITUDE_BITS + pineda_pkg::BIAS_SLOPE_BITS + 1;
  logic signed [SUM_BITS-1:0] sum;
  assign sum = slope_i + (SUM_BITS'(signed'(frame_i.bias_constant)) <<
                          pineda_pkg::BIAS_FRACTION_BITS);

  logic fits;
  assign fits = sum[SUM_BITS-1:BITS-1] == '0 || sum[SUM_BITS-1:BITS-1] == '1;
  assign bias_o = fits ? sum[BITS-1:0] : {sum[SUM_BITS-1], {(BITS-1){!sum[SUM_BITS-1]}}};
endmodule
`endif
