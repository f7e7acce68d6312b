// The covered samples of a tile: groups of TESTED_STAMPS stamps side by side inside the triangle's
// box, row by row from the top, each from the left.
//
// Bits     core::StampWalk defines them.
// In       tile_i; start_e_i: its edges at the first sample of the first group.
// Out      group_o: the masks of a group's stamps, the left one's lowest; at least one sample is
//          covered. stamp_o: the first of them but for its mask; `first` belongs to the first that is
//          sent.
// Rate     a group is tested a cycle, as long as groups with a covered sample are taken; the others
//          are passed over. From one tile to the next without a bubble, unless TILE_FIFO_DEPTH is 0.
// Twin     model/core/traversal.cpp.
module coverage_finder (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic                tile_valid_i,
  output logic                tile_ready_o,
  input  pineda_pkg::tile_t   tile_i,
  input  logic [3*pineda_pkg::TILE_EDGE_BITS-1:0]  start_e_i,

  output logic                group_valid_o,
  input  logic                group_ready_i,
  output logic [(pineda_pkg::LANES<<pineda_pkg::TESTED_STAMPS_LOG2)-1:0]  group_o,
  output pineda_pkg::stamp_t  stamp_o,

  output logic                busy_o
);
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned EDGE_BITS = pineda_pkg::TILE_EDGE_BITS;
  localparam int unsigned TILE_LOG2 = pineda_pkg::TILE_LOG2;
  localparam int unsigned HEIGHT_LOG2 = pineda_pkg::STAMP_HEIGHT_LOG2;
  localparam int unsigned STAMPS = 1 << pineda_pkg::TESTED_STAMPS_LOG2;
  localparam int unsigned STAMP_PX = 1 << pineda_pkg::STAMP_WIDTH_LOG2;
  localparam int unsigned WIDTH_LOG2 = pineda_pkg::STAMP_WIDTH_LOG2 + pineda_pkg::TESTED_STAMPS_LOG2;
  localparam int unsigned COLUMNS = 1 << WIDTH_LOG2; // of samples
  localparam int unsigned ROWS = 1 << HEIGHT_LOG2;
  // Group column and row inside the tile, always 0 where a group is a tile wide or high
  localparam int unsigned X_BITS = TILE_LOG2 > WIDTH_LOG2 ? TILE_LOG2 - WIDTH_LOG2 : 1;
  localparam int unsigned Y_BITS = TILE_LOG2 > HEIGHT_LOG2 ? TILE_LOG2 - HEIGHT_LOG2 : 1;
  localparam int unsigned STAMP_X_BITS = pineda_pkg::STAMP_X_BITS;
  localparam int unsigned STAMP_Y_BITS = pineda_pkg::STAMP_Y_BITS;

  logic busy_q;
  logic first_q; // no group of the tile has been sent
  pineda_pkg::tile_t tile_q; // its e are those of the first sample of the group under test
  logic [X_BITS-1:0] x_q;
  logic [Y_BITS-1:0] y_q;
  logic [3*EDGE_BITS-1:0] row_e_q; // of the row's first group
`ifdef PINEDA_PERSPECTIVE
  logic [3*EDGE_BITS-1:0] tile_e_q; // at the tile's first sample
`endif

  logic advance, row_end, last_group;
  assign group_valid_o = busy_q && group_o != '0;
  assign advance = busy_q && (group_o == '0 || group_ready_i);
  assign row_end = x_q == X_BITS'(tile_q.x1 >> WIDTH_LOG2);
  assign last_group = row_end && y_q == Y_BITS'(tile_q.y1 >> HEIGHT_LOG2);
  assign tile_ready_o = !busy_q || (pineda_pkg::TILE_FIFO_DEPTH > 0 && advance && last_group);
  assign busy_o = busy_q;

  // ---- The test: a sample is covered when it lies in the box and no edge is negative there
  logic [3*ROWS*COLUMNS-1:0] negative; // row by row, three edges a sample
  for (genvar i = 0; i < 3; i++) begin : gen_edges
    logic signed [EDGE_BITS-1:0] a, b;
    assign a = EDGE_BITS'(signed'(tile_q.a[i*COEFF_BITS +: COEFF_BITS]));
    assign b = EDGE_BITS'(signed'(tile_q.b[i*COEFF_BITS +: COEFF_BITS]));
    for (genvar column = 0; column < COLUMNS; column++) begin : gen_columns
      logic signed [EDGE_BITS-1:0] top;
      assign top = signed'(tile_q.e[i*EDGE_BITS +: EDGE_BITS]) + a * EDGE_BITS'(column);
      for (genvar row = 0; row < ROWS; row++) begin : gen_rows
        logic signed [EDGE_BITS-1:0] e;
        assign e = top + b * EDGE_BITS'(row);
        assign negative[3*(row*COLUMNS+column)+i] = e < 0 && !tile_q.accepted[i];
      end
    end
  end
  for (genvar stamp = 0; stamp < STAMPS; stamp++) begin : gen_stamps
    for (genvar lane = 0; lane < pineda_pkg::LANES; lane++) begin : gen_lanes
      localparam int unsigned COLUMN = stamp * STAMP_PX + lane % STAMP_PX;
      localparam int unsigned ROW = lane / STAMP_PX;
      logic [TILE_LOG2-1:0] px, py;
      assign px = (TILE_LOG2'(x_q) << WIDTH_LOG2) + TILE_LOG2'(COLUMN);
      assign py = (TILE_LOG2'(y_q) << HEIGHT_LOG2) + TILE_LOG2'(ROW);
      assign group_o[stamp*pineda_pkg::LANES+lane] =
          px >= tile_q.x0 && px <= tile_q.x1 && py >= tile_q.y0 && py <= tile_q.y1 &&
          negative[3*(ROW*COLUMNS+COLUMN) +: 3] == '0;
    end
  end

  // ---- What its stamps share
  always_comb begin
    stamp_o = '0;
    stamp_o.id = tile_q.id;
    stamp_o.x = (STAMP_X_BITS'(tile_q.x) << (TILE_LOG2 - pineda_pkg::STAMP_WIDTH_LOG2)) +
                (STAMP_X_BITS'(x_q) << pineda_pkg::TESTED_STAMPS_LOG2);
    stamp_o.y = (STAMP_Y_BITS'(tile_q.y) << (TILE_LOG2 - HEIGHT_LOG2)) + STAMP_Y_BITS'(y_q);
    stamp_o.first = first_q;
`ifdef PINEDA_DEPTH
    stamp_o.z_dx = tile_q.z_dx;
    stamp_o.z_dy = tile_q.z_dy;
    stamp_o.z_ref = tile_q.z_ref;
    stamp_o.z_bias = tile_q.z_bias;
`endif
`ifdef PINEDA_AFFINE
    stamp_o.attr_dx = tile_q.attr_dx;
    stamp_o.attr_dy = tile_q.attr_dy;
    stamp_o.attr_ref = tile_q.attr_ref;
`endif
`ifdef PINEDA_PERSPECTIVE
    stamp_o.a = tile_q.a;
    stamp_o.b = tile_q.b;
    stamp_o.e = tile_e_q;
    stamp_o.e_low = tile_q.e_low;
    stamp_o.inverse_w = tile_q.inverse_w;
    stamp_o.inverse_w_shift = tile_q.inverse_w_shift;
    stamp_o.vertex_attr = tile_q.vertex_attr;
`endif
`ifdef PINEDA_FLAT_ATTRIBUTES
    stamp_o.flat = tile_q.flat;
`endif
  end

  // ---- The walk
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) busy_q <= 1'b0;
    else if (!busy_q || (advance && last_group)) busy_q <= tile_valid_i && tile_ready_o;
  end

  // Group by group, or from the row's first one down, by the same adders
  logic [3*EDGE_BITS-1:0] next_e;
  for (genvar i = 0; i < 3; i++) begin : gen_walk
    assign next_e[i*EDGE_BITS +: EDGE_BITS] =
        (row_end ? row_e_q[i*EDGE_BITS +: EDGE_BITS] : tile_q.e[i*EDGE_BITS +: EDGE_BITS]) +
        (row_end ? EDGE_BITS'(signed'(tile_q.b[i*COEFF_BITS +: COEFF_BITS])) << HEIGHT_LOG2
                 : EDGE_BITS'(signed'(tile_q.a[i*COEFF_BITS +: COEFF_BITS])) << WIDTH_LOG2);
  end

  always_ff @(posedge clk_i) begin
    if (tile_valid_i && tile_ready_o) begin
      tile_q <= tile_i;
`ifdef PINEDA_PERSPECTIVE
      tile_e_q <= tile_i.e;
`endif
      first_q <= 1'b1;
      x_q <= X_BITS'(tile_i.x0 >> WIDTH_LOG2);
      y_q <= Y_BITS'(tile_i.y0 >> HEIGHT_LOG2);
      tile_q.e <= start_e_i;
      row_e_q <= start_e_i;
    end else if (advance) begin
      if (group_valid_o) first_q <= 1'b0;
      x_q <= row_end ? X_BITS'(tile_q.x0 >> WIDTH_LOG2) : x_q + X_BITS'(1);
      y_q <= row_end ? y_q + Y_BITS'(1) : y_q;
      tile_q.e <= next_e;
      if (row_end) row_e_q <= next_e;
    end
  end

`ifdef PINEDA_COUNTERS
  cycle_counters #(.Kinds(cycle_cause_pkg::CAUSES)) u_cycles (
    .clk_i, .count_i(1'b1),
    .kind_i(!busy_q ? cycle_cause_pkg::STARVED :
            advance ? cycle_cause_pkg::BUSY : cycle_cause_pkg::BLOCKED)
  );
`endif
endmodule
