// The planes of a triangle from one multiplier: eight products each, and one for the depth bias.
//
// Bits     core::setup() defines them.
// In       tri_i in canonical order (anchor first) and its offsets, held; mantissa_i and length_i
//          from 4 cycles after start_i on; product_i: the factors' product, a cycle after them.
// Out      factors while busy_o; valid_o the cycle after a plane's last product was asked for, with
//          index_o: 0 is the first plane, depth if there is any; bias_valid_o likewise.
// Rate     a product an enabled cycle.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_SETUP_SERIAL
`ifdef PINEDA_PLANES
module setup_serial_planes (
  input  logic                                               clk_i,
  input  logic                                               rst_ni,
  input  logic                                               enable_i,
`ifdef PINEDA_DEPTH
  input  pineda_pkg::frame_t                                 frame_i,
`endif

  input  logic                                               start_i,
  input  pineda_pkg::triangle_t                              tri_i,
  // Vertices 1 and 2 from the anchor; the first sample from the anchor
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]      dx1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]      dy1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]      dx2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]      dy2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]      ref_x_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]      ref_y_i,
  input  logic [pineda_pkg::RECIPROCAL_BITS-1:0]             mantissa_i,
  input  logic [pineda_pkg::AREA2_LENGTH_BITS-1:0]           length_i,

  output logic                                               busy_o,
  output logic signed [pineda_pkg::SETUP_FACTOR_A_BITS-1:0]  factor_a_o,
  output logic signed [pineda_pkg::SETUP_FACTOR_B_BITS-1:0]  factor_b_o,
  input  logic signed [pineda_pkg::SETUP_FACTOR_A_BITS+pineda_pkg::SETUP_FACTOR_B_BITS-1:0]
                                                             product_i,

  output logic                                               valid_o,
  output logic [$clog2(pineda_pkg::PLANES+1)-1:0]            index_o,
  output logic signed [pineda_pkg::PLANE_BITS-1:0]           dx_o,
  output logic signed [pineda_pkg::PLANE_BITS-1:0]           dy_o,
`ifdef PINEDA_DEPTH
  output logic                                               bias_valid_o,
  output logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0]      bias_o,
`ifdef PINEDA_HIERARCHICAL_Z
  output logic                                               steep_o,
`endif
`endif
  output logic signed [pineda_pkg::PLANE_BITS-1:0]           ref_o
);
  localparam int unsigned S = pineda_pkg::SUBPIXEL_BITS;
  localparam int unsigned F = pineda_pkg::GRADIENT_FRACTION_BITS;
  localparam int unsigned A_BITS = pineda_pkg::SETUP_FACTOR_A_BITS;
  localparam int unsigned B_BITS = pineda_pkg::SETUP_FACTOR_B_BITS;
  localparam int unsigned VALUE_BITS = pineda_pkg::VALUE_BITS;
  localparam int unsigned NUMERATOR_BITS = pineda_pkg::NUMERATOR_BITS;
  localparam int unsigned PRODUCT_BITS = NUMERATOR_BITS + pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned PLANE_BITS = pineda_pkg::PLANE_BITS;
  // The reference lies a fraction of a pixel from the anchor: S more high bits before the wrap.
  localparam int unsigned WIDE_BITS = PLANE_BITS + S;
  localparam int unsigned SUM_BITS = NUMERATOR_BITS + 1 > WIDE_BITS ? NUMERATOR_BITS + 1 : WIDE_BITS;
  localparam int unsigned PLANES = pineda_pkg::PLANES;
  localparam int unsigned INDEX_BITS = $clog2(PLANES + 1);

  // ---- Control. Phases 0 to 8 each ask for a product and take up the one before; phase 7 is that
  // of the depth bias.
  logic busy_q, valid_q;
  logic [3:0] phase_q;
  logic [INDEX_BITS-1:0] index_q;
`ifdef PINEDA_DEPTH
  logic is_depth;
  assign is_depth = index_q == '0;
`else
  localparam logic is_depth = 1'b0;
`endif
  assign busy_o = busy_q;
  assign valid_o = valid_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      valid_q <= 1'b0;
      phase_q <= '0;
      index_q <= '0;
    end else if (enable_i) begin
      valid_q <= busy_q && phase_q == 4'd8;
      if (start_i) begin
        busy_q <= 1'b1;
        phase_q <= '0;
        index_q <= '0;
      end else if (busy_q && phase_q == 4'd8) begin
        busy_q <= index_q != INDEX_BITS'(PLANES - 1);
        phase_q <= '0;
        index_q <= index_q + INDEX_BITS'(1);
      end else if (busy_q) begin
        phase_q <= phase_q == 4'd6 && !is_depth ? 4'd8 : phase_q + 4'd1;
      end
    end
  end
  assign index_o = index_q - INDEX_BITS'(1); // phase 8 has moved on

  // ---- What the products are made of
  logic [3*VALUE_BITS-1:0] values;
  logic [VALUE_BITS-1:0] value0, value1, value2;
  logic signed [VALUE_BITS:0] d1, d2;
  setup_values u_values (.valid_i(busy_q), .index_i(index_q), .tri_i, .values_o(values));
  assign {value2, value1, value0} = values;
  assign d1 = signed'({1'b0, value1}) - signed'({1'b0, value0});
  assign d2 = signed'({1'b0, value2}) - signed'({1'b0, value0});

  logic signed [SUM_BITS-1:0] sum_q, product;
  logic signed [NUMERATOR_BITS-1:0] numerator_q;
  logic signed [WIDE_BITS-1:0] gradient, gradient_x_q, gradient_y_q;
  logic signed [PRODUCT_BITS-1:0] cut;
  assign product = SUM_BITS'(product_i);
  setup_gradient #(
    .ProductBits(PRODUCT_BITS), .FractionBits(pineda_pkg::VALUE_FRACTION_BITS),
    .WideBits(WIDE_BITS)
  ) u_gradient (
    .product_i(product_i[PRODUCT_BITS-1:0]), .length_i, .cut_o(cut), .gradient_o(gradient)
  );

`ifdef PINEDA_DEPTH
  localparam int unsigned MAGNITUDE_BITS = pineda_pkg::BIAS_MAGNITUDE_BITS;
  logic [MAGNITUDE_BITS:0] part;
  logic [MAGNITUDE_BITS-1:0] magnitude, magnitude_q;
  setup_magnitude #(.CutBits(PRODUCT_BITS)) u_magnitude (
    .cut_i(cut), .part_o(part), .part_i(part), .magnitude_o(magnitude)
  );
  setup_bias u_bias (
    .frame_i, .slope_i(product_i[MAGNITUDE_BITS+pineda_pkg::BIAS_SLOPE_BITS:0]), .bias_o
  );
`ifdef PINEDA_HIERARCHICAL_Z
  assign steep_o = magnitude_q[MAGNITUDE_BITS-1:pineda_pkg::HIERARCHICAL_Z_STEEP_LOG2] != '0;
`endif
  assign bias_valid_o = busy_q && is_depth && phase_q == 4'd8;
`endif

  always_comb begin
    factor_a_o = 'x;
    factor_b_o = 'x;
    case (phase_q)
      4'd0: begin factor_a_o = A_BITS'(d1); factor_b_o = B_BITS'(dy2_i); end
      4'd1: begin factor_a_o = A_BITS'(d2); factor_b_o = B_BITS'(dy1_i); end
      4'd2: begin factor_a_o = A_BITS'(d2); factor_b_o = B_BITS'(dx1_i); end
      4'd3: begin factor_a_o = A_BITS'(d1); factor_b_o = B_BITS'(dx2_i); end
      4'd4, 4'd5: begin
        factor_a_o = A_BITS'(numerator_q);
        factor_b_o = B_BITS'(signed'({1'b0, mantissa_i}));
      end
      4'd6: begin factor_a_o = A_BITS'(gradient_x_q); factor_b_o = B_BITS'(ref_x_i); end
`ifdef PINEDA_DEPTH
      4'd7: begin
        factor_a_o = A_BITS'(signed'({1'b0, magnitude_q}));
        factor_b_o = B_BITS'(frame_i.bias_slope);
      end
`endif
      default: begin factor_a_o = A_BITS'(gradient_y_q); factor_b_o = B_BITS'(ref_y_i); end
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (enable_i && busy_q) begin
      case (phase_q)
        4'd1, 4'd3: sum_q <= product;
        4'd2, 4'd4: numerator_q <= NUMERATOR_BITS'(sum_q - product);
        4'd5: gradient_x_q <= gradient;
        4'd6: gradient_y_q <= gradient;
        default: ;
      endcase
      // After phase 6. The reference has S fraction bits too many, rounded away, halves up.
      if (phase_q == 4'd7 || (phase_q == 4'd8 && !is_depth)) begin
        sum_q <= product + (SUM_BITS'(value0) << (F - pineda_pkg::VALUE_FRACTION_BITS + S)) +
                 SUM_BITS'(1 << (S - 1));
      end
`ifdef PINEDA_DEPTH
      if (phase_q == 4'd5 || (phase_q == 4'd6 && magnitude > magnitude_q)) magnitude_q <= magnitude;
`endif
    end
  end

  logic signed [SUM_BITS-1:0] at_ref;
  assign at_ref = sum_q + product;
  assign ref_o = at_ref[WIDE_BITS-1:S];
  assign dx_o = gradient_x_q[PLANE_BITS-1:0];
  assign dy_o = gradient_y_q[PLANE_BITS-1:0];
endmodule
`endif
`endif
