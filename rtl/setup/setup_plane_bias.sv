// The depth bias beside the pipeline that makes the depth plane.
//
// Bits     core::setup() defines the bias of its depth plane.
// In       the gradients of depth; valid_i: this cycle, the one after it, and those of the product.
// Out      bias_o after these; steep_o: hierarchical z knows nothing of such a plane.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_DEPTH
module setup_plane_bias #(
  parameter int unsigned CutBits = pineda_pkg::DEPTH_NUMERATOR_BITS,
  parameter int unsigned Stages = 1 // of the product
) (
  input  logic                                           clk_i,
  input  logic                                           enable_i,
  input  logic [1+Stages:0]                              valid_i,
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
  logic [MAGNITUDE_BITS:0] part_x, part_y, part_x_q, part_y_q;
  logic [MAGNITUDE_BITS-1:0] magnitude, magnitude_q, magnitude_y_unused;
  setup_magnitude #(.CutBits(CutBits)) u_x (
    .cut_i(cut_x_i), .part_o(part_x),
    .part_i(part_x_q > part_y_q ? part_x_q : part_y_q), .magnitude_o(magnitude)
  );
  setup_magnitude #(.CutBits(CutBits)) u_y (
    .cut_i(cut_y_i), .part_o(part_y), .part_i('0), .magnitude_o(magnitude_y_unused)
  );

  logic signed [SLOPE_BITS-1:0] slope;
  multiplier_pipelined #(
    .ABits(MAGNITUDE_BITS + 1), .BBits(pineda_pkg::BIAS_SLOPE_BITS), .Stages(Stages)
  ) u_slope (
    .clk_i, .enable_i, .valid_i(valid_i[2 +: Stages]),
    .a_i({1'b0, magnitude_q}), .b_i(frame_i.bias_slope), .addend_i('0), .product_o(slope)
  );
  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (valid_i[0]) {part_x_q, part_y_q} <= {part_x, part_y};
      if (valid_i[1]) magnitude_q <= magnitude;
    end
  end
`ifdef PINEDA_HIERARCHICAL_Z
  delay_line #(.Width(1), .Depth(Stages)) u_steep (
    .clk_i, .enable_i,
    .data_i(magnitude_q[MAGNITUDE_BITS-1:pineda_pkg::HIERARCHICAL_Z_STEEP_LOG2] != '0),
    .data_o(steep_o)
  );
`endif
  setup_bias u_bias (.frame_i, .slope_i(slope), .bias_o);
endmodule
`endif
