// The depth bias beside the pipeline that makes the depth plane.
//
// Bits     core::setup() defines the bias of its depth plane.
// In       the gradients of depth; valid_i: this cycle and the two after it.
// Out      bias_o after these; steep_o: hierarchical z knows nothing of such a plane.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_DEPTH
module setup_plane_bias #(
  parameter int unsigned CutBits = pineda_pkg::DEPTH_NUMERATOR_BITS
) (
  input  logic                                           clk_i,
  input  logic                                           enable_i,
  input  logic [2:0]                                     valid_i,
  input  pineda_pkg::frame_t                             frame_i,
  input  logic signed [CutBits-1:0]                      cut_x_i,
  input  logic signed [CutBits-1:0]                      cut_y_i,
`ifdef PINEDA_HIERARCHICAL_Z
  output logic                                           steep_o,
`endif
  output logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0]  bias_o
);
  localparam int unsigned MAGNITUDE_BITS = pineda_pkg::BIAS_MAGNITUDE_BITS;
  localparam int unsigned SLOPE_BITS = MAGNITUDE_BITS + pineda_pkg::BIAS_SLOPE_BITS + 1;
  logic signed [MAGNITUDE_BITS+1:0] saturated_x, saturated_y, saturated_x_q, saturated_y_q;
  logic [MAGNITUDE_BITS-1:0] magnitude_x, magnitude_y, magnitude_x_q, magnitude_y_q, magnitude;
  setup_magnitude #(.CutBits(CutBits)) u_x (
    .cut_i(cut_x_i), .saturated_o(saturated_x),
    .saturated_i(saturated_x_q), .magnitude_o(magnitude_x)
  );
  setup_magnitude #(.CutBits(CutBits)) u_y (
    .cut_i(cut_y_i), .saturated_o(saturated_y),
    .saturated_i(saturated_y_q), .magnitude_o(magnitude_y)
  );
  assign magnitude = magnitude_x_q > magnitude_y_q ? magnitude_x_q : magnitude_y_q;

  logic signed [SLOPE_BITS-1:0] slope, slope_q;
  multiplier #(.ABits(MAGNITUDE_BITS + 1), .BBits(pineda_pkg::BIAS_SLOPE_BITS)) u_slope (
    .a_i({1'b0, magnitude}), .b_i(frame_i.bias_slope), .addend_i('0), .product_o(slope)
  );
  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (valid_i[0]) {saturated_x_q, saturated_y_q} <= {saturated_x, saturated_y};
      if (valid_i[1]) {magnitude_x_q, magnitude_y_q} <= {magnitude_x, magnitude_y};
      if (valid_i[2]) slope_q <= slope;
    end
  end
`ifdef PINEDA_HIERARCHICAL_Z
  always_ff @(posedge clk_i) begin
    if (enable_i && valid_i[2]) begin
      steep_o <= magnitude[MAGNITUDE_BITS-1:pineda_pkg::HIERARCHICAL_Z_STEEP_LOG2] != '0;
    end
  end
`endif
  setup_bias u_bias (.frame_i, .slope_i(slope_q), .bias_o);
endmodule
`endif
