// Attributes corrected by perspective, at the samples of a stamp that passed the depth test.
//
// Bits     core::perspective_attributes() defines them. Lanes outside the mask are 0.
// In       load_i with the stamp's place inside its tile and what its triangle's samples share; from the next cycle on start_i with the samples that passed.
// Out      attr_o, ATTRIBUTE_CYCLES - 1 cycles after start_i.
// Rate     a stamp a cycle; nothing stops it, so the consumer must have room.
// Twin     model/core/perspective.cpp.
`ifdef PINEDA_PERSPECTIVE
module perspective_interpolator (
  input  logic                                                     clk_i,
  input  logic                                                     rst_ni,

  input  logic                                                     load_i,
  input  logic [pineda_pkg::STAMP_COLUMN_BITS-1:0]                 column_i,
  input  logic [pineda_pkg::STAMP_ROW_BITS-1:0]                    row_i,
  input  logic [3*pineda_pkg::EDGE_COEFF_BITS-1:0]                 a_i,
  input  logic [3*pineda_pkg::EDGE_COEFF_BITS-1:0]                 b_i,
  input  logic [3*pineda_pkg::EDGE_BITS-1:0]                       e_i,
  input  logic [3*pineda_pkg::SUBPIXEL_BITS-1:0]                   e_low_i,
  input  logic [3*pineda_pkg::INVERSE_W_BITS-1:0]                  inverse_w_i,
  input  logic [3*pineda_pkg::INVERSE_W_SHIFT_BITS-1:0]            inverse_w_shift_i,
  input  logic [3*pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_BITS-1:0] vertex_attr_i,

  input  logic                                                     start_i,
  input  logic [pineda_pkg::LANES-1:0]                             mask_i,
  output logic                                                     attr_valid_o,
  output logic [pineda_pkg::LANES*pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_BITS-1:0] attr_o
);
  localparam int unsigned LANES = pineda_pkg::LANES;
  localparam int unsigned WIDTH_LOG2 = pineda_pkg::STAMP_WIDTH_LOG2;
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned EDGE_BITS = pineda_pkg::EDGE_BITS;
  localparam int unsigned ATTRS_BITS = pineda_pkg::ATTRIBUTES * pineda_pkg::ATTR_BITS;
  localparam int unsigned STAGES = pineda_pkg::ATTRIBUTE_CYCLES - 1;
  localparam int unsigned M = pineda_pkg::MULTIPLIER_STAGES;
  localparam int unsigned TERMS = STAGES - M; // where lanes take the vertices' attributes

  // ---- The stamp to start: edges at its first sample
  logic [3*COEFF_BITS-1:0] a_q, b_q;
  logic [3*EDGE_BITS-1:0] e_q;
  logic [3*pineda_pkg::SUBPIXEL_BITS-1:0] e_low_q;
  logic [3*pineda_pkg::INVERSE_W_BITS-1:0] inverse_w_q, inverse_w;
  logic [3*pineda_pkg::INVERSE_W_SHIFT_BITS-1:0] shift_q, shift;
  logic [3*ATTRS_BITS-1:0] vertex_attr_q, vertex_attr;
  always_ff @(posedge clk_i) begin
    if (load_i) begin
      a_q <= a_i;
      b_q <= b_i;
      for (int unsigned n = 0; n < 3; n++) begin
        e_q[n*EDGE_BITS +: EDGE_BITS] <=
            e_i[n*EDGE_BITS +: EDGE_BITS] +
            ((EDGE_BITS'(signed'(a_i[n*COEFF_BITS +: COEFF_BITS])) * EDGE_BITS'(column_i))
             << WIDTH_LOG2) +
            ((EDGE_BITS'(signed'(b_i[n*COEFF_BITS +: COEFF_BITS])) * EDGE_BITS'(row_i))
             << pineda_pkg::STAMP_HEIGHT_LOG2);
      end
      e_low_q <= e_low_i;
      inverse_w_q <= inverse_w_i;
      shift_q <= inverse_w_shift_i;
      vertex_attr_q <= vertex_attr_i;
    end
  end

  // ---- The lanes that have a sample in each stage, the first stage lowest. A stamp that starts
  // has at least one.
  logic [STAGES*LANES-1:0] mask_q;
  logic [STAGES:0] valid;
  assign valid[0] = start_i;
  for (genvar stage = 0; stage < STAGES; stage++) begin : gen_stages
    assign valid[stage+1] = mask_q[stage*LANES +: LANES] != '0;
  end
  assign attr_valid_o = valid[STAGES];
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) mask_q <= '0;
    else mask_q <= {mask_q[(STAGES-1)*LANES-1:0], start_i ? mask_i : '0};
  end

  // ---- What all lanes of a stamp share goes along beside them
  delay_line #(.Width(3*pineda_pkg::INVERSE_W_BITS), .Depth(1)) u_inverse_w (
    .clk_i, .enable_i(1'b1), .data_i(inverse_w_q), .data_o(inverse_w)
  );
  delay_line #(.Width(3*pineda_pkg::INVERSE_W_SHIFT_BITS), .Depth(1 + M)) u_shift (
    .clk_i, .enable_i(1'b1), .data_i(shift_q), .data_o(shift)
  );
  logic vertices_ready, vertices_valid;
  stream_fifo #(.Width(3*ATTRS_BITS), .Depth(TERMS+1)) u_vertices (
    .clk_i, .rst_ni,
    .in_valid_i(start_i), .in_ready_o(vertices_ready), .in_data_i(vertex_attr_q),
    .out_valid_o(vertices_valid), .out_ready_i(valid[TERMS]), .out_data_o(vertex_attr)
  );

  for (genvar lane = 0; lane < LANES; lane++) begin : gen_lanes
    logic [STAGES:0] lane_valid;
    assign lane_valid[0] = start_i && mask_i[lane];
    for (genvar stage = 0; stage < STAGES; stage++) begin : gen_lane_stages
      assign lane_valid[stage+1] = mask_q[stage*LANES+lane];
    end
    perspective_lane #(
      .Column(lane % (1 << WIDTH_LOG2)), .Row(lane / (1 << WIDTH_LOG2))
    ) u_lane (
      .clk_i, .rst_ni,
      .valid_i(lane_valid),
      .a_i(a_q), .b_i(b_q), .e_i(e_q), .e_low_i(e_low_q),
      .inverse_w_i(inverse_w), .inverse_w_shift_i(shift),
      .vertex_attr_i(vertex_attr),
      .attr_o(attr_o[lane*ATTRS_BITS +: ATTRS_BITS])
    );
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!start_i || mask_i != '0) else $error("a stamp without lanes");
      assert (!start_i || vertices_ready) else $error("vertices find their FIFO full");
      assert (!valid[TERMS] || vertices_valid) else $error("lanes without vertices");
    end
  end
`endif
endmodule
`endif
