// Depth at the covered samples of a stamp.
//
// Bits     core::interpolate_depth() defines them: ref + i*dx + j*dy modulo the plane's width, plus
//          the bias; one rounding, halves up, and a clamp. Lanes outside the mask are 0.
// In       the stamp's place inside its tile, its mask and its plane; tag_i goes with it.
// Out      z_o, 2 cycles later.
// Rate     a stamp a cycle.
// Twin     model/core/interp.cpp.
`ifdef PINEDA_DEPTH
module depth_interpolator #(
  parameter int unsigned TagBits = 1
) (
  input  logic                                                clk_i,
  input  logic                                                rst_ni,

  input  logic                                                stamp_valid_i,
  output logic                                                stamp_ready_o,
  input  logic        [pineda_pkg::STAMP_COLUMN_BITS-1:0]     column_i,
  input  logic        [pineda_pkg::STAMP_ROW_BITS-1:0]        row_i,
  input  logic        [pineda_pkg::LANES-1:0]                 mask_i,
  input  logic signed [pineda_pkg::DEPTH_TILE_PLANE_BITS-1:0] z_dx_i,
  input  logic signed [pineda_pkg::DEPTH_TILE_PLANE_BITS-1:0] z_dy_i,
  input  logic signed [pineda_pkg::DEPTH_TILE_PLANE_BITS-1:0] z_ref_i,
  input  logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0]       z_bias_i,
  input  logic [TagBits-1:0]                                  tag_i,

  output logic                                                z_valid_o,
  input  logic                                                z_ready_i,
  output logic [TagBits-1:0]                                  tag_o,
  output logic [pineda_pkg::LANES*pineda_pkg::DEPTH_BITS-1:0] z_o
);
  localparam int unsigned LANES = pineda_pkg::LANES;
  localparam int unsigned WIDTH_LOG2 = pineda_pkg::STAMP_WIDTH_LOG2;
  localparam int unsigned PLANE_BITS = pineda_pkg::DEPTH_TILE_PLANE_BITS;
  localparam int unsigned OUT_BITS = pineda_pkg::DEPTH_BITS;

  // ---- Two stages, each with a register
  logic valid1_q, valid2_q, ready2;
  assign ready2 = !valid2_q || z_ready_i;
  assign stamp_ready_o = !valid1_q || ready2;
  assign z_valid_o = valid2_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid1_q <= 1'b0;
      valid2_q <= 1'b0;
    end else begin
      if (stamp_ready_o) valid1_q <= stamp_valid_i;
      if (ready2) valid2_q <= valid1_q;
    end
  end

  // ---- 1: the plane at the stamp's first sample
  logic [LANES-1:0] mask1_q;
  logic [TagBits-1:0] tag1_q, tag2_q;
  logic signed [PLANE_BITS-1:0] z1_q, z_dx1_q, z_dy1_q;
  logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0] bias1_q;
  assign tag_o = tag2_q;
  always_ff @(posedge clk_i) begin
    if (stamp_valid_i && stamp_ready_o) begin
      mask1_q <= mask_i;
      z1_q <= z_ref_i + ((z_dx_i * PLANE_BITS'(signed'({1'b0, column_i}))) <<< WIDTH_LOG2) +
              ((z_dy_i * PLANE_BITS'(signed'({1'b0, row_i}))) <<< pineda_pkg::STAMP_HEIGHT_LOG2);
      z_dx1_q <= z_dx_i;
      z_dy1_q <= z_dy_i;
      bias1_q <= z_bias_i;
      tag1_q <= tag_i;
    end
    if (valid1_q && ready2) tag2_q <= tag1_q;
  end

  // ---- 2: the codes
  logic [LANES*OUT_BITS-1:0] z2_q;
  assign z_o = z2_q;
  for (genvar lane = 0; lane < LANES; lane++) begin : gen_lanes
    localparam int unsigned COLUMN = lane % (1 << WIDTH_LOG2);
    localparam int unsigned ROW = lane / (1 << WIDTH_LOG2);
    logic signed [PLANE_BITS-1:0] value;
    logic [OUT_BITS-1:0] code;
    // 'x while the lane has no sample: it costs no gate and saves the simulator work.
    always_comb begin
      value = 'x;
      if (valid1_q && mask1_q[lane]) begin
        value = z1_q + z_dx1_q * PLANE_BITS'(signed'({1'b0, COLUMN[2:0]})) +
                z_dy1_q * PLANE_BITS'(signed'({1'b0, ROW[2:0]}));
      end
    end
    depth_code u_code (.value_i(value), .bias_i(bias1_q), .code_o(code));
    always_ff @(posedge clk_i) begin
      if (valid1_q && ready2) z2_q[lane*OUT_BITS +: OUT_BITS] <= mask1_q[lane] ? code : '0;
    end
  end
endmodule
`endif
