// The planes of a triangle, one after the other through one pipeline: depth, then the attributes.
//
// Bits     core::setup() defines them. Gradients and references wrap by design.
// In       vertices in canonical order (anchor first), held for ATTRIBUTES + 6 cycles after start_i;
//          mantissa_i from 3 cycles after start_i on, and length_i from 4.
// Out      plane_valid_o for ATTRIBUTES + 1 cycles from 6 cycles after start_i on, in order:
//          depth first. An attribute's plane is the low ATTR_PLANE_BITS of each value.
// Rate     a plane every enabled cycle.
// Twin     model/core/setup.cpp, plane().
module setup_planes (
  input  logic                                                   clk_i,
  input  logic                                                   rst_ni,
  input  logic                                                   enable_i,

  input  logic                                                   start_i,
  // Vertices 1 and 2 from the anchor; the first sample from the anchor
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]          dx1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]          dy1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]          dx2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]          dy2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]          ref_x_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]          ref_y_i,
  input  logic [3*pineda_pkg::DEPTH_IN_BITS-1:0]                 z_i,
  input  logic [3*pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_BITS-1:0] attr_i,
  input  logic [pineda_pkg::RECIPROCAL_BITS-1:0]                 mantissa_i,
  input  logic [pineda_pkg::AREA2_LENGTH_BITS-1:0]               length_i,

  output logic                                                   plane_valid_o,
  output logic signed [pineda_pkg::DEPTH_PLANE_BITS-1:0]         dx_o,
  output logic signed [pineda_pkg::DEPTH_PLANE_BITS-1:0]         dy_o,
  output logic signed [pineda_pkg::DEPTH_PLANE_BITS-1:0]         ref_o,
  output logic                                                   busy_o
);
  localparam int unsigned Z_BITS = pineda_pkg::DEPTH_IN_BITS;
  localparam int unsigned Z_FRACTION = pineda_pkg::DEPTH_INPUT_FRACTION_BITS;
  localparam int unsigned ATTRIBUTES = pineda_pkg::ATTRIBUTES;
  localparam int unsigned ATTR_BITS = pineda_pkg::ATTR_BITS;
  localparam int unsigned NUMERATOR_BITS = pineda_pkg::DEPTH_NUMERATOR_BITS;
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned PRODUCT_BITS = NUMERATOR_BITS + K;
  localparam int unsigned PLANE_BITS = pineda_pkg::DEPTH_PLANE_BITS;
  localparam int unsigned S = pineda_pkg::SUBPIXEL_BITS;
  localparam int unsigned F = pineda_pkg::GRADIENT_FRACTION_BITS;
  // The reference lies a fraction of a pixel from the anchor: S more high bits before the wrap.
  localparam int unsigned WIDE_BITS = PLANE_BITS + S;
  localparam int unsigned INDEX_BITS = $clog2(ATTRIBUTES + 2);
  localparam int unsigned STAGES = 6;
  localparam int unsigned SHIFT_BITS = 7;

  // Which plane stands in stage 0, and which stages are occupied.
  logic [INDEX_BITS-1:0] index_q;
  logic active_q;
  logic stage0;
  logic [STAGES-1:0] valid_q;
  assign stage0 = start_i || active_q;
  assign busy_o = stage0 || valid_q != '0;
  assign plane_valid_o = valid_q[STAGES-1];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      index_q  <= '0;
      active_q <= 1'b0;
      valid_q  <= '0;
    end else if (enable_i) begin
      valid_q <= {valid_q[STAGES-2:0], stage0};
      if (stage0) begin
        index_q  <= index_q == INDEX_BITS'(ATTRIBUTES) ? '0 : index_q + INDEX_BITS'(1);
        active_q <= index_q != INDEX_BITS'(ATTRIBUTES);
      end
    end
  end

  // Stage 0: the values at the three vertices, in units of 2^-Z_FRACTION whatever they are. 'x while
  // the stage is empty costs no gate and saves the simulator the work.
  logic [Z_BITS-1:0] value0, value1, value2;
  always_comb begin
    value0 = 'x;
    value1 = 'x;
    value2 = 'x;
    if (stage0) begin
      value0 = z_i[0 +: Z_BITS];
      value1 = z_i[Z_BITS +: Z_BITS];
      value2 = z_i[2*Z_BITS +: Z_BITS];
      for (int unsigned i = 0; i < ATTRIBUTES; i++) begin
        if (index_q == INDEX_BITS'(i + 1)) begin
          value0 = Z_BITS'(attr_i[i*ATTR_BITS +: ATTR_BITS]) << Z_FRACTION;
          value1 = Z_BITS'(attr_i[(ATTRIBUTES+i)*ATTR_BITS +: ATTR_BITS]) << Z_FRACTION;
          value2 = Z_BITS'(attr_i[(2*ATTRIBUTES+i)*ATTR_BITS +: ATTR_BITS]) << Z_FRACTION;
        end
      end
    end
  end

  logic signed [Z_BITS:0] d1_q, d2_q;
  logic [Z_BITS-1:0] base1_q, base2_q, base3_q, base4_q, base5_q;
  logic signed [NUMERATOR_BITS:0] p1y2_q, p2y1_q, p2x1_q, p1x2_q;
  logic signed [NUMERATOR_BITS-1:0] numerator_x_q, numerator_y_q;
  logic signed [PRODUCT_BITS-1:0] product_x_q, product_y_q;
  logic signed [WIDE_BITS-1:0] gradient_x_q, gradient_y_q;
  logic signed [PLANE_BITS-1:0] dx_q, dy_q;
  logic signed [WIDE_BITS-1:0] at_ref_x_q, at_ref_y_q, base_q;

  // gradient = product * 2^-shift, halves up: cut one bit short of it, add one, halve.
  localparam int unsigned SHIFT_BASE = K - 2 - F - S + Z_FRACTION;
  logic [SHIFT_BITS-1:0] shift_less_1;
  assign shift_less_1 = SHIFT_BITS'(length_i) + SHIFT_BITS'(SHIFT_BASE);
  logic signed [WIDE_BITS:0] cut_x, cut_y;
  assign cut_x = (WIDE_BITS+1)'(product_x_q >>> shift_less_1);
  assign cut_y = (WIDE_BITS+1)'(product_y_q >>> shift_less_1);
  logic signed [WIDE_BITS:0] halved_x, halved_y;
  assign halved_x = (cut_x + (WIDE_BITS+1)'(1)) >>> 1;
  assign halved_y = (cut_y + (WIDE_BITS+1)'(1)) >>> 1;

  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      if (stage0) begin
        d1_q <= signed'({1'b0, value1}) - signed'({1'b0, value0});
        d2_q <= signed'({1'b0, value2}) - signed'({1'b0, value0});
        base1_q <= value0;
      end
      if (valid_q[0]) begin // four products
        p1y2_q <= (NUMERATOR_BITS+1)'(d1_q) * (NUMERATOR_BITS+1)'(dy2_i);
        p2y1_q <= (NUMERATOR_BITS+1)'(d2_q) * (NUMERATOR_BITS+1)'(dy1_i);
        p2x1_q <= (NUMERATOR_BITS+1)'(d2_q) * (NUMERATOR_BITS+1)'(dx1_i);
        p1x2_q <= (NUMERATOR_BITS+1)'(d1_q) * (NUMERATOR_BITS+1)'(dx2_i);
        base2_q <= base1_q;
      end
      if (valid_q[1]) begin
        numerator_x_q <= NUMERATOR_BITS'(p1y2_q - p2y1_q);
        numerator_y_q <= NUMERATOR_BITS'(p2x1_q - p1x2_q);
        base3_q <= base2_q;
      end
      if (valid_q[2]) begin
        product_x_q <= PRODUCT_BITS'(numerator_x_q) * PRODUCT_BITS'(signed'({1'b0, mantissa_i}));
        product_y_q <= PRODUCT_BITS'(numerator_y_q) * PRODUCT_BITS'(signed'({1'b0, mantissa_i}));
        base4_q <= base3_q;
      end
      if (valid_q[3]) begin
        gradient_x_q <= halved_x[WIDE_BITS-1:0];
        gradient_y_q <= halved_y[WIDE_BITS-1:0];
        base5_q <= base4_q;
      end
      if (valid_q[4]) begin
        dx_q <= gradient_x_q[PLANE_BITS-1:0];
        dy_q <= gradient_y_q[PLANE_BITS-1:0];
        at_ref_x_q <= gradient_x_q * WIDE_BITS'(ref_x_i);
        at_ref_y_q <= gradient_y_q * WIDE_BITS'(ref_y_i);
        base_q <= WIDE_BITS'(base5_q) << (F - Z_FRACTION + S);
      end
    end
  end

  // The reference: S fraction bits too many, rounded away, halves up.
  logic signed [WIDE_BITS-1:0] at_ref;
  assign at_ref = base_q + at_ref_x_q + at_ref_y_q + WIDE_BITS'(1 << (S - 1));
  assign ref_o = at_ref[WIDE_BITS-1:S];
  assign dx_o = dx_q;
  assign dy_o = dy_q;
endmodule
