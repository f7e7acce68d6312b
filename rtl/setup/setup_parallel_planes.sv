// The planes of a triangle a cycle: a pipeline for each of them, one reciprocal for all.
//
// Bits     core::setup() defines them.
// In       with M = MULTIPLIER_STAGES: area2_i in cycle 4 + M of the triangle, in the next one the
//          triangle in canonical order and its offsets; valid_i: which of the cycles from
//          SETUP_PLANES_STEP on have one.
// Out      prim_o: prim_i with the planes, in cycle SETUP_PLANES_STEP + 4 + 3M.
// Rate     a triangle an enabled cycle.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_SETUP_PIPELINED
`ifdef PINEDA_PLANES
module setup_parallel_planes (
  input  logic                                           clk_i,
  input  logic                                           rst_ni,
  input  logic                                           enable_i,
`ifdef PINEDA_DEPTH
  input  pineda_pkg::frame_t                             frame_i,
`endif

  input  logic                                           area2_valid_i,
  input  logic [pineda_pkg::AREA2_BITS-2:0]              area2_i,
  input  logic [3+3*pineda_pkg::MULTIPLIER_STAGES:0]     valid_i,
  input  pineda_pkg::triangle_t                          tri_i,
  // Vertices 1 and 2 from the anchor; the first sample from the anchor
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  ref_x_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  ref_y_i,

  input  pineda_pkg::setup_prim_t                        prim_i,
  output pineda_pkg::setup_prim_t                        prim_o
);
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned START = pineda_pkg::SETUP_PLANES_STEP; // cycle of stage 0
  localparam int unsigned K = pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned LENGTH_BITS = pineda_pkg::AREA2_LENGTH_BITS;
  localparam int unsigned M = pineda_pkg::MULTIPLIER_STAGES;
  localparam int unsigned AREA = 4 + M;
  localparam int unsigned OFFSETS = AREA + 1;
  localparam int unsigned RECIPROCAL_DONE = AREA + pineda_pkg::PIPELINED_RECIPROCAL_CYCLES;

  // ---- The inputs of the stages, each delayed to the cycle in which its stage takes it
  logic [K-1:0] mantissa, start_mantissa;
  logic [LENGTH_BITS-1:0] length, start_length;
  reciprocal_pipelined #(.LengthBits(LENGTH_BITS)) u_reciprocal (
    .clk_i, .rst_ni, .enable_i, .valid_i(area2_valid_i), .value_i(area2_i),
    .length_o(length), .mantissa_o(mantissa)
  );
  delay_line #(.Width(K), .Depth(START + 2 + M - RECIPROCAL_DONE)) u_mantissa (
    .clk_i, .enable_i, .data_i(mantissa), .data_o(start_mantissa)
  );
  delay_line #(.Width(LENGTH_BITS), .Depth(START + 2 + 2*M - RECIPROCAL_DONE)) u_length (
    .clk_i, .enable_i, .data_i(length), .data_o(start_length)
  );
  pineda_pkg::triangle_t start_tri;
  delay_line #(.Width(pineda_pkg::TRIANGLE_BITS), .Depth(START - OFFSETS)) u_tri (
    .clk_i, .enable_i, .data_i(tri_i), .data_o(start_tri)
  );
  logic signed [COEFF_BITS-1:0] dx1, dy1, dx2, dy2, ref_x, ref_y;
  delay_line #(.Width(4*COEFF_BITS), .Depth(START + 1 - OFFSETS)) u_differences (
    .clk_i, .enable_i, .data_i({dx1_i, dy1_i, dx2_i, dy2_i}), .data_o({dx1, dy1, dx2, dy2})
  );
  delay_line #(.Width(2*COEFF_BITS), .Depth(START + 3 + 2*M - OFFSETS)) u_reference (
    .clk_i, .enable_i, .data_i({ref_x_i, ref_y_i}), .data_o({ref_x, ref_y})
  );

`ifdef PINEDA_DEPTH
  localparam int unsigned CUT_BITS = pineda_pkg::DEPTH_NUMERATOR_BITS + K;
  logic signed [CUT_BITS-1:0] cut_x, cut_y;
  logic signed [pineda_pkg::DEPTH_PLANE_BITS-1:0] z_dx, z_dy, z_ref;
  logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0] z_bias;
`ifdef PINEDA_HIERARCHICAL_Z
  logic z_steep;
`endif
  setup_plane u_depth (
    .clk_i, .enable_i, .valid_i, .values_i(start_tri.z),
    .dx1_i(dx1), .dy1_i(dy1), .dx2_i(dx2), .dy2_i(dy2),
    .mantissa_i(start_mantissa), .length_i(start_length), .ref_x_i(ref_x), .ref_y_i(ref_y),
    .cut_x_o(cut_x), .cut_y_o(cut_y), .dx_o(z_dx), .dy_o(z_dy), .ref_o(z_ref)
  );
  setup_plane_bias #(.CutBits(CUT_BITS), .Stages(M)) u_bias (
    .clk_i, .enable_i, .valid_i(valid_i[2+2*M +: 2+M]), .frame_i, .cut_x_i(cut_x), .cut_y_i(cut_y),
`ifdef PINEDA_HIERARCHICAL_Z
    .steep_o(z_steep),
`endif
    .bias_o(z_bias)
  );
`endif

`ifdef PINEDA_AFFINE
  localparam int unsigned ATTRIBUTES = pineda_pkg::ATTRIBUTES;
  localparam int unsigned ATTR_BITS = pineda_pkg::ATTR_BITS;
  localparam int unsigned BITS = pineda_pkg::ATTR_PLANE_BITS;
  // Attributes are integers, but get one fraction bit, always 0: the gradient is shifted by one
  // less than its fraction bits say, which must not be negative. VALUE_FRACTION_BITS does the same.
  localparam int unsigned VALUE_BITS = ATTR_BITS + 1;
  localparam int unsigned NUMERATOR_BITS = pineda_pkg::ATTR_NUMERATOR_BITS + 1;
  logic [ATTRIBUTES*BITS-1:0] attr_dx, attr_dy, attr_ref;
  for (genvar i = 0; i < ATTRIBUTES; i++) begin : g_attribute
    logic [3*VALUE_BITS-1:0] values;
    for (genvar v = 0; v < 3; v++) begin : g_vertex
      assign values[v*VALUE_BITS +: VALUE_BITS] =
          {start_tri.attr[(v*ATTRIBUTES+i)*ATTR_BITS +: ATTR_BITS], 1'b0};
    end
    logic [NUMERATOR_BITS+K-1:0] no_bias_x, no_bias_y;
    setup_plane #(
      .ValueBits(VALUE_BITS), .FractionBits(1), .NumeratorBits(NUMERATOR_BITS), .PlaneBits(BITS)
    ) u_plane (
      .clk_i, .enable_i, .valid_i, .values_i(values),
      .dx1_i(dx1), .dy1_i(dy1), .dx2_i(dx2), .dy2_i(dy2),
      .mantissa_i(start_mantissa), .length_i(start_length), .ref_x_i(ref_x), .ref_y_i(ref_y),
      .cut_x_o(no_bias_x), .cut_y_o(no_bias_y),
      .dx_o(attr_dx[i*BITS +: BITS]), .dy_o(attr_dy[i*BITS +: BITS]),
      .ref_o(attr_ref[i*BITS +: BITS])
    );
  end
`endif

  always_comb begin
    prim_o = prim_i;
`ifdef PINEDA_DEPTH
    prim_o.z_dx = z_dx;
    prim_o.z_dy = z_dy;
    prim_o.z_ref = z_ref;
    prim_o.z_bias = z_bias;
`ifdef PINEDA_HIERARCHICAL_Z
    prim_o.z_steep = z_steep;
`endif
`endif
`ifdef PINEDA_AFFINE
    prim_o.attr_dx = attr_dx;
    prim_o.attr_dy = attr_dy;
    prim_o.attr_ref = attr_ref;
`endif
  end
endmodule
`endif
`endif
