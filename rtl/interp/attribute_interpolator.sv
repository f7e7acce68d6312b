// Affine attributes at the samples of a stamp that passed the depth test.
//
// Bits     core::interpolate_attributes() defines them: ref + i*dx + j*dy modulo the plane's width,
//          one rounding, halves up, and a clamp. Lanes outside the mask are 0.
// In       load_i with the stamp's place inside its tile and its planes; from the next cycle
//          on start_i with the samples that passed.
// Out      attr_o, in the cycle of start_i.
// Rate     a stamp a cycle.
// Twin     model/core/interp.cpp.
`ifdef PINEDA_AFFINE
module attribute_interpolator (
  input  logic                                                               clk_i,

  input  logic                                                               load_i,
  input  logic [pineda_pkg::STAMP_COLUMN_BITS-1:0]                           column_i,
  input  logic [pineda_pkg::STAMP_ROW_BITS-1:0]                              row_i,
  input  logic [pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_TILE_PLANE_BITS-1:0] attr_dx_i,
  input  logic [pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_TILE_PLANE_BITS-1:0] attr_dy_i,
  input  logic [pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_TILE_PLANE_BITS-1:0] attr_ref_i,

  input  logic                                                               start_i,
  input  logic [pineda_pkg::LANES-1:0]                                       mask_i,
  output logic [pineda_pkg::LANES*pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_BITS-1:0] attr_o
);
  localparam int unsigned LANES = pineda_pkg::LANES;
  localparam int unsigned WIDTH_LOG2 = pineda_pkg::STAMP_WIDTH_LOG2;
  localparam int unsigned F = pineda_pkg::TILE_FRACTION_BITS;
  localparam int unsigned ATTRIBUTES = pineda_pkg::ATTRIBUTES;
  localparam int unsigned PLANE_BITS = pineda_pkg::ATTR_TILE_PLANE_BITS;
  localparam int unsigned OUT_BITS = pineda_pkg::ATTR_BITS;

  logic [ATTRIBUTES*PLANE_BITS-1:0] attr_q, attr_dx_q, attr_dy_q; // attr_q: at the first sample
  always_ff @(posedge clk_i) begin
    if (load_i) begin
      for (int unsigned a = 0; a < ATTRIBUTES; a++) begin
        attr_q[a*PLANE_BITS +: PLANE_BITS] <=
            attr_ref_i[a*PLANE_BITS +: PLANE_BITS] +
            ((attr_dx_i[a*PLANE_BITS +: PLANE_BITS] * PLANE_BITS'(column_i)) << WIDTH_LOG2) +
            ((attr_dy_i[a*PLANE_BITS +: PLANE_BITS] * PLANE_BITS'(row_i))
             << pineda_pkg::STAMP_HEIGHT_LOG2);
      end
      attr_dx_q <= attr_dx_i;
      attr_dy_q <= attr_dy_i;
    end
  end

  function automatic logic [OUT_BITS-1:0] code(input logic signed [PLANE_BITS-1:0] value);
    logic signed [PLANE_BITS-F:0] rounded;
    rounded = (PLANE_BITS-F+1)'(signed'(value[PLANE_BITS-1:F])) +
              (PLANE_BITS-F+1)'(signed'({1'b0, value[F-1]}));
    if (rounded < 0) code = '0;
    else if (rounded[PLANE_BITS-F:OUT_BITS] != '0) code = '1;
    else code = rounded[OUT_BITS-1:0];
  endfunction

  for (genvar lane = 0; lane < LANES; lane++) begin : gen_lanes
    localparam int unsigned COLUMN = lane % (1 << WIDTH_LOG2);
    localparam int unsigned ROW = lane / (1 << WIDTH_LOG2);
    always_comb begin
      attr_o[lane*ATTRIBUTES*OUT_BITS +: ATTRIBUTES*OUT_BITS] = '0;
      if (start_i && mask_i[lane]) begin
        for (int unsigned a = 0; a < ATTRIBUTES; a++) begin
          attr_o[(lane*ATTRIBUTES+a)*OUT_BITS +: OUT_BITS] =
              code(attr_q[a*PLANE_BITS +: PLANE_BITS] +
                   attr_dx_q[a*PLANE_BITS +: PLANE_BITS] * PLANE_BITS'(COLUMN) +
                   attr_dy_q[a*PLANE_BITS +: PLANE_BITS] * PLANE_BITS'(ROW));
        end
      end
    end
  end
endmodule
`endif
