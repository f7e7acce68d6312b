// Depth at the covered samples of a stamp.
//
// Bits     core::interpolate_depth() defines them: ref + i*dx + j*dy modulo the plane's width, plus
//          the bias; one rounding, halves up, and a clamp. Lanes outside the mask are 0.
// In       stamp_valid_i with the stamp's place inside its tile, px, its mask and its plane.
// Out      one cycle later: z_o.
// Rate     a stamp a cycle; the consumer has room by construction, so there is no ready.
// Twin     model/core/interp.cpp.
`ifdef PINEDA_DEPTH
module depth_interpolator (
  input  logic                                                clk_i,
  input  logic                                                rst_ni,

  input  logic                                                stamp_valid_i,
  input  logic        [pineda_pkg::TILE_LOG2-1:0]             i_i,
  input  logic        [pineda_pkg::TILE_LOG2-1:0]             j_i,
  input  logic        [pineda_pkg::LANES-1:0]                 mask_i,
  input  logic signed [pineda_pkg::DEPTH_TILE_PLANE_BITS-1:0] z_dx_i,
  input  logic signed [pineda_pkg::DEPTH_TILE_PLANE_BITS-1:0] z_dy_i,
  input  logic signed [pineda_pkg::DEPTH_TILE_PLANE_BITS-1:0] z_ref_i,
  input  logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0]       z_bias_i,

  output logic                                                z_valid_o,
  output logic [pineda_pkg::LANES*pineda_pkg::DEPTH_BITS-1:0] z_o
);
  localparam int unsigned LANES = pineda_pkg::LANES;
  localparam int unsigned WIDTH_LOG2 = pineda_pkg::STAMP_WIDTH_LOG2;
  localparam int unsigned PLANE_BITS = pineda_pkg::DEPTH_TILE_PLANE_BITS;
  localparam int unsigned OUT_BITS = pineda_pkg::DEPTH_BITS;

  // The plane at the stamp's first sample
  logic valid_q;
  logic [LANES-1:0] mask_q;
  logic signed [PLANE_BITS-1:0] z_q, z_dx_q, z_dy_q;
  logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0] bias_q;
  assign z_valid_o = valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else valid_q <= stamp_valid_i;
  end

  always_ff @(posedge clk_i) begin
    if (stamp_valid_i) begin
      mask_q <= mask_i;
      z_q <= z_ref_i + z_dx_i * PLANE_BITS'(signed'({1'b0, i_i})) +
             z_dy_i * PLANE_BITS'(signed'({1'b0, j_i}));
      z_dx_q <= z_dx_i;
      z_dy_q <= z_dy_i;
      bias_q <= z_bias_i;
    end
  end

  for (genvar lane = 0; lane < LANES; lane++) begin : gen_lanes
    localparam int unsigned COLUMN = lane % (1 << WIDTH_LOG2);
    localparam int unsigned ROW = lane / (1 << WIDTH_LOG2);
    logic signed [PLANE_BITS-1:0] value;
    logic [OUT_BITS-1:0] code;
    // 'x while the lane has no sample: it costs no gate and saves the simulator work.
    always_comb begin
      value = 'x;
      if (valid_q && mask_q[lane]) begin
        value = z_q + z_dx_q * PLANE_BITS'(signed'({1'b0, COLUMN[2:0]})) +
                z_dy_q * PLANE_BITS'(signed'({1'b0, ROW[2:0]}));
      end
    end
    depth_code u_code (.value_i(value), .bias_i(bias_q), .code_o(code));
    assign z_o[lane*OUT_BITS +: OUT_BITS] = valid_q && mask_q[lane] ? code : '0;
  end
endmodule
`endif
