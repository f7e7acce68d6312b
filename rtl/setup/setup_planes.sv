// The planes of a triangle, one after the other through one pipeline: depth, then the attributes.
//
// Bits     core::setup() defines them.
// In       tri_i in canonical order (anchor first), held for PLANES + 5 cycles after start_i, like
//          its offsets; mantissa_i from 3 cycles after start_i on, and length_i from 4.
// Out      valid_o for PLANES cycles from 6 cycles after start_i on, in order: index_o. bias_o
//          and steep_o are those of depth while index_o is 0.
// Rate     a plane every enabled cycle.
// Twin     model/core/planes.cpp.
`ifdef PINEDA_PLANES
module setup_planes (
  input  logic                                           clk_i,
  input  logic                                           rst_ni,
  input  logic                                           enable_i,
`ifdef PINEDA_DEPTH
  input  pineda_pkg::frame_t                             frame_i,
`endif

  input  logic                                           start_i,
  input  pineda_pkg::triangle_t                          tri_i,
  // Vertices 1 and 2 from the anchor; the first sample from the anchor
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy1_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dx2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  dy2_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  ref_x_i,
  input  logic signed [pineda_pkg::EDGE_COEFF_BITS-1:0]  ref_y_i,
  input  logic [pineda_pkg::RECIPROCAL_BITS-1:0]         mantissa_i,
  input  logic [pineda_pkg::AREA2_LENGTH_BITS-1:0]       length_i,

  output logic                                           valid_o,
  output logic [$clog2(pineda_pkg::PLANES+1)-1:0]        index_o,
  output logic signed [pineda_pkg::PLANE_BITS-1:0]       dx_o,
  output logic signed [pineda_pkg::PLANE_BITS-1:0]       dy_o,
  output logic signed [pineda_pkg::PLANE_BITS-1:0]       ref_o,
`ifdef PINEDA_DEPTH
  output logic signed [pineda_pkg::DEPTH_BIAS_BITS-1:0]  bias_o,
`ifdef PINEDA_HIERARCHICAL_Z
  output logic                                           steep_o,
`endif
`endif
  output logic                                           busy_o
);
  localparam int unsigned PLANES = pineda_pkg::PLANES;
  localparam int unsigned INDEX_BITS = $clog2(PLANES + 1);
  localparam int unsigned CUT_BITS = pineda_pkg::NUMERATOR_BITS + pineda_pkg::RECIPROCAL_BITS;
  localparam int unsigned STAGES = 6;

  // Which plane stands in stage 0 and which one comes out, and which stages are taken.
  logic [INDEX_BITS-1:0] index_q, out_index_q;
  logic active_q;
  logic stage0;
  logic [STAGES-1:0] valid_q;
  assign stage0 = start_i || active_q;
  assign busy_o = stage0 || valid_q != '0;
  assign valid_o = valid_q[STAGES-1];
  assign index_o = out_index_q;

  function automatic logic [INDEX_BITS-1:0] next(input logic [INDEX_BITS-1:0] index);
    next = index == INDEX_BITS'(PLANES - 1) ? '0 : index + INDEX_BITS'(1);
  endfunction
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      index_q <= '0;
      out_index_q <= '0;
      active_q <= 1'b0;
      valid_q <= '0;
    end else if (enable_i) begin
      valid_q <= {valid_q[STAGES-2:0], stage0};
      if (stage0) begin
        index_q <= next(index_q);
        active_q <= next(index_q) != '0;
      end
      if (valid_o) out_index_q <= next(out_index_q);
    end
  end

  logic [3*pineda_pkg::VALUE_BITS-1:0] values;
  setup_values u_values (.valid_i(stage0), .index_i(index_q), .tri_i, .values_o(values));

  logic signed [CUT_BITS-1:0] cut_x, cut_y;
  setup_plane u_plane (
    .clk_i, .enable_i, .valid_i({valid_q[STAGES-2:0], stage0}),
    .values_i(values), .dx1_i, .dy1_i, .dx2_i, .dy2_i, .mantissa_i, .length_i, .ref_x_i, .ref_y_i,
    .cut_x_o(cut_x), .cut_y_o(cut_y), .dx_o, .dy_o, .ref_o
  );
`ifdef PINEDA_DEPTH
  setup_plane_bias #(.CutBits(CUT_BITS)) u_bias (
    .clk_i, .enable_i, .valid_i(valid_q[4:3]), .frame_i, .cut_x_i(cut_x), .cut_y_i(cut_y),
`ifdef PINEDA_HIERARCHICAL_Z
    .steep_o,
`endif
    .bias_o
  );
`endif
endmodule
`endif
