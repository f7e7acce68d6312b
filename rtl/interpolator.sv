// Depth and attributes at the covered samples of a stamp.
//
// Bits     core::interpolate() defines them: ref + i*dx + j*dy modulo the plane's width, one
//          rounding, halves up, and a clamp. Lanes outside the mask are 0.
// In       stamp_i.
// Out      one cycle later: address, mask, z, attr.
// Rate     a stamp a cycle; the consumer has room by construction, so there is no ready.
// Twin     model/core/interp.cpp.
module interpolator (
  input  logic                                         clk_i,
  input  logic                                         rst_ni,

  input  logic                                         stamp_valid_i,
  input  pineda_pkg::stamp_t                           stamp_i,

  output logic                                         fragment_valid_o,
  output pineda_pkg::depth_read_t                      address_o, // with the mask
  output logic [pineda_pkg::LANES*pineda_pkg::DEPTH_BITS-1:0] z_o,
  output logic [pineda_pkg::LANES*pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_BITS-1:0] attr_o
);
  localparam int unsigned LANES = pineda_pkg::LANES;
  localparam int unsigned TILE_LOG2 = pineda_pkg::TILE_LOG2;
  localparam int unsigned WIDTH_LOG2 = pineda_pkg::STAMP_WIDTH_LOG2;
  localparam int unsigned HEIGHT_LOG2 = pineda_pkg::STAMP_HEIGHT_LOG2;
  localparam int unsigned F = pineda_pkg::TILE_FRACTION_BITS;
  localparam int unsigned Z_BITS = pineda_pkg::DEPTH_TILE_PLANE_BITS;
  localparam int unsigned OUT_Z_BITS = pineda_pkg::DEPTH_BITS;
  localparam int unsigned ATTRIBUTES = pineda_pkg::ATTRIBUTES;
  localparam int unsigned A_BITS = pineda_pkg::ATTR_TILE_PLANE_BITS;
  localparam int unsigned OUT_A_BITS = pineda_pkg::ATTR_BITS;

  // The stamp's first sample from the tile's
  logic signed [TILE_LOG2:0] i, j;
  assign i = signed'({1'b0, stamp_i.x[TILE_LOG2-WIDTH_LOG2-1:0], {WIDTH_LOG2{1'b0}}});
  assign j = signed'({1'b0, stamp_i.y[TILE_LOG2-HEIGHT_LOG2-1:0], {HEIGHT_LOG2{1'b0}}});

  logic valid_q;
  pineda_pkg::depth_read_t address_q;
  logic signed [Z_BITS-1:0] z_q, z_dx_q, z_dy_q; // z_q: at the stamp's first sample
  logic [ATTRIBUTES*A_BITS-1:0] attr_q, attr_dx_q, attr_dy_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else valid_q <= stamp_valid_i;
  end

  always_ff @(posedge clk_i) begin
    if (stamp_valid_i) begin
      address_q.id <= stamp_i.id;
      address_q.x <= stamp_i.x;
      address_q.y <= stamp_i.y;
      address_q.mask <= stamp_i.mask;
      z_q <= stamp_i.z_ref + stamp_i.z_dx * Z_BITS'(i) + stamp_i.z_dy * Z_BITS'(j);
      z_dx_q <= stamp_i.z_dx;
      z_dy_q <= stamp_i.z_dy;
      for (int unsigned a = 0; a < ATTRIBUTES; a++) begin
        attr_q[a*A_BITS +: A_BITS] <=
            stamp_i.attr_ref[a*A_BITS +: A_BITS] +
            stamp_i.attr_dx[a*A_BITS +: A_BITS] * A_BITS'(i) +
            stamp_i.attr_dy[a*A_BITS +: A_BITS] * A_BITS'(j);
      end
      attr_dx_q <= stamp_i.attr_dx;
      attr_dy_q <= stamp_i.attr_dy;
    end
  end

  assign fragment_valid_o = valid_q;
  assign address_o = address_q;

  // A plane's value, rounded and clamped to its output.
  function automatic logic [OUT_Z_BITS-1:0] depth_code(input logic signed [Z_BITS-1:0] value);
    logic signed [Z_BITS-F:0] rounded;
    rounded = (Z_BITS-F+1)'(signed'(value[Z_BITS-1:F])) +
              (Z_BITS-F+1)'(signed'({1'b0, value[F-1]}));
    if (rounded < 0) depth_code = '0;
    else if (rounded[Z_BITS-F:OUT_Z_BITS] != '0) depth_code = '1;
    else depth_code = rounded[OUT_Z_BITS-1:0];
  endfunction
  function automatic logic [OUT_A_BITS-1:0] attr_code(input logic signed [A_BITS-1:0] value);
    logic signed [A_BITS-F:0] rounded;
    rounded = (A_BITS-F+1)'(signed'(value[A_BITS-1:F])) +
              (A_BITS-F+1)'(signed'({1'b0, value[F-1]}));
    if (rounded < 0) attr_code = '0;
    else if (rounded[A_BITS-F:OUT_A_BITS] != '0) attr_code = '1;
    else attr_code = rounded[OUT_A_BITS-1:0];
  endfunction

  for (genvar lane = 0; lane < LANES; lane++) begin : gen_lanes
    localparam int unsigned COLUMN = lane % (1 << WIDTH_LOG2);
    localparam int unsigned ROW = lane / (1 << WIDTH_LOG2);
    always_comb begin
      z_o[lane*OUT_Z_BITS +: OUT_Z_BITS] = '0;
      attr_o[lane*ATTRIBUTES*OUT_A_BITS +: ATTRIBUTES*OUT_A_BITS] = '0;
      if (valid_q && address_q.mask[lane]) begin
        z_o[lane*OUT_Z_BITS +: OUT_Z_BITS] =
            depth_code(z_q + z_dx_q * Z_BITS'(signed'({1'b0, COLUMN[2:0]})) +
                       z_dy_q * Z_BITS'(signed'({1'b0, ROW[2:0]})));
        for (int unsigned a = 0; a < ATTRIBUTES; a++) begin
          attr_o[(lane*ATTRIBUTES+a)*OUT_A_BITS +: OUT_A_BITS] =
              attr_code(attr_q[a*A_BITS +: A_BITS] +
                        attr_dx_q[a*A_BITS +: A_BITS] * A_BITS'(COLUMN) +
                        attr_dy_q[a*A_BITS +: A_BITS] * A_BITS'(ROW));
        end
      end
    end
  end
endmodule
