// The depth bias beside the pipeline that makes the depth plane: in the same cycle.
//
// Bits     core::setup() defines the bias of its depth plane.
// In       the gradients of depth in stage 4 of setup_plane; valid_i: stages 4 and 5.
// Out      bias_o after stage 5; steep_o: hierarchical z knows nothing of such a plane.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_DEPTH
module setup_plane_bias #(
  parameter int unsigned CutBits = pineda_pkg::DEPTH_NUMERATOR_BITS
) (
  input  logic                                           clk_i,
  input  logic                                           enable_i,
  input  logic [1:0]                                     valid_i,
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
  logic [MAGNITUDE_BITS-1:0] magnitude_x, magnitude_y, magnitude_x_q, magnitude_y_q, magnitude;
  setup_magnitude #(.CutBits(CutBits)) u_x (.cut_i(cut_x_i), .magnitude_o(magnitude_x));
  setup_magnitude #(.CutBits(CutBits)) u_y (.cut_i(cut_y_i), .magnitude_o(magnitude_y));
  assign magnitude = magnitude_x_q > magnitude_y_q ? magnitude_x_q : magnitude_y_q;

  logic signed [SLOPE_BITS-1:0] slope_q;
  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (valid_i[0]) begin
        magnitude_x_q <= magnitude_x;
        magnitude_y_q <= magnitude_y;
      end
      if (valid_i[1]) begin
        slope_q <= SLOPE_BITS'(signed'({1'b0, magnitude})) * SLOPE_BITS'(frame_i.bias_slope);
      end
    end
  end
`ifdef PINEDA_HIERARCHICAL_Z
  always_ff @(posedge clk_i) begin
    if (enable_i && valid_i[1]) begin
      steep_o <= magnitude[MAGNITUDE_BITS-1:pineda_pkg::HIERARCHICAL_Z_STEEP_LOG2] != '0;
    end
  end
`endif
  setup_bias u_bias (.frame_i, .slope_i(slope_q), .bias_o);
endmodule
`endif
