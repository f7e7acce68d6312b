// The stamps of a tile inside the triangle's box, row by row from the top, each from the left.
//
// Bits     core::StampWalk defines them.
// In       tile_i.
// Out      stamp_o: a stamp with at least one covered sample; empty ones are tested, not sent.
// Rate     one stamp test a cycle, from one tile to the next without a bubble, as long as stamps
//          are taken: an accepted tile sends a stamp every cycle.
// Twin     model/core/traversal.cpp.
module stamp_walker (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic                tile_valid_i,
  output logic                tile_ready_o,
  input  pineda_pkg::tile_t   tile_i,

  output logic                stamp_valid_o,
  input  logic                stamp_ready_i,
  output pineda_pkg::stamp_t  stamp_o,

  output logic                idle_o
);
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned EDGE_BITS = pineda_pkg::TILE_EDGE_BITS;
  localparam int unsigned TILE_LOG2 = pineda_pkg::TILE_LOG2;
  localparam int unsigned WIDTH_LOG2 = pineda_pkg::STAMP_WIDTH_LOG2;
  localparam int unsigned HEIGHT_LOG2 = pineda_pkg::STAMP_HEIGHT_LOG2;
  localparam int unsigned LANES = pineda_pkg::LANES;
  // Stamp column and row inside the tile, always 0 where a stamp is a tile wide or high
  localparam int unsigned X_BITS = TILE_LOG2 > WIDTH_LOG2 ? TILE_LOG2 - WIDTH_LOG2 : 1;
  localparam int unsigned Y_BITS = TILE_LOG2 > HEIGHT_LOG2 ? TILE_LOG2 - HEIGHT_LOG2 : 1;
  localparam int unsigned STAMP_X_BITS = pineda_pkg::STAMP_X_BITS;
  localparam int unsigned STAMP_Y_BITS = pineda_pkg::STAMP_Y_BITS;

  logic busy_q;
  pineda_pkg::tile_t tile_q; // its e are those of the stamp under test
  logic [X_BITS-1:0] x_q;
  logic [Y_BITS-1:0] y_q;
  logic [3*EDGE_BITS-1:0] row_e_q; // at the first stamp of the row
`ifdef PINEDA_PERSPECTIVE
  logic [3*EDGE_BITS-1:0] tile_e_q; // at the tile's first sample
`endif
`ifdef PINEDA_DEPTH
  logic first_q; // no stamp of the tile has been sent
`endif
  logic stamp_valid_q;
  pineda_pkg::stamp_t stamp_q;

  logic [LANES-1:0] mask;
  logic out_free, advance, row_end, last_stamp;
  assign out_free = !stamp_valid_q || stamp_ready_i;
  assign advance = busy_q && (mask == '0 || out_free);
  assign row_end = x_q == X_BITS'(tile_q.x1 >> WIDTH_LOG2);
  assign last_stamp = row_end && y_q == Y_BITS'(tile_q.y1 >> HEIGHT_LOG2);
  assign tile_ready_o = !busy_q || (advance && last_stamp);
  assign stamp_valid_o = stamp_valid_q;
  assign stamp_o = stamp_q;
  assign idle_o = !busy_q && !stamp_valid_q;

  // ---- The test: a lane is covered when it lies in the box and no edge is negative there
  for (genvar lane = 0; lane < LANES; lane++) begin : gen_lanes
    localparam int unsigned COLUMN = lane % (1 << WIDTH_LOG2);
    localparam int unsigned ROW = lane / (1 << WIDTH_LOG2);
    logic [TILE_LOG2-1:0] px, py;
    logic [2:0] outside;
    assign px = (TILE_LOG2'(x_q) << WIDTH_LOG2) + TILE_LOG2'(COLUMN);
    assign py = (TILE_LOG2'(y_q) << HEIGHT_LOG2) + TILE_LOG2'(ROW);
    for (genvar i = 0; i < 3; i++) begin : gen_edges
      logic signed [EDGE_BITS-1:0] e;
      assign e = signed'(tile_q.e[i*EDGE_BITS +: EDGE_BITS]) +
                 EDGE_BITS'(signed'(tile_q.a[i*COEFF_BITS +: COEFF_BITS])) *
                     EDGE_BITS'(signed'({1'b0, COLUMN[2:0]})) +
                 EDGE_BITS'(signed'(tile_q.b[i*COEFF_BITS +: COEFF_BITS])) *
                     EDGE_BITS'(signed'({1'b0, ROW[2:0]}));
      assign outside[i] = e < 0 && !tile_q.accepted[i];
    end
    assign mask[lane] = px >= tile_q.x0 && px <= tile_q.x1 && py >= tile_q.y0 &&
                        py <= tile_q.y1 && outside == '0;
  end

  // ---- The walk
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      stamp_valid_q <= 1'b0;
    end else begin
      if (tile_ready_o) busy_q <= tile_valid_i;
      if (out_free) stamp_valid_q <= busy_q && mask != '0;
    end
  end

  // Offset of the box's first stamp inside the tile
  logic signed [TILE_LOG2:0] start_x, start_y;
  assign start_x = signed'({1'b0, (tile_i.x0 >> WIDTH_LOG2) << WIDTH_LOG2});
  assign start_y = signed'({1'b0, (tile_i.y0 >> HEIGHT_LOG2) << HEIGHT_LOG2});

  always_ff @(posedge clk_i) begin
    if (tile_valid_i && tile_ready_o) begin
      tile_q <= tile_i;
`ifdef PINEDA_PERSPECTIVE
      tile_e_q <= tile_i.e;
`endif
      x_q <= X_BITS'(tile_i.x0 >> WIDTH_LOG2);
      y_q <= Y_BITS'(tile_i.y0 >> HEIGHT_LOG2);
`ifdef PINEDA_DEPTH
      first_q <= 1'b1;
`endif
      for (int unsigned i = 0; i < 3; i++) begin
        tile_q.e[i*EDGE_BITS +: EDGE_BITS] <=
            tile_i.e[i*EDGE_BITS +: EDGE_BITS] +
            EDGE_BITS'(signed'(tile_i.a[i*COEFF_BITS +: COEFF_BITS])) * EDGE_BITS'(start_x) +
            EDGE_BITS'(signed'(tile_i.b[i*COEFF_BITS +: COEFF_BITS])) * EDGE_BITS'(start_y);
        row_e_q[i*EDGE_BITS +: EDGE_BITS] <=
            tile_i.e[i*EDGE_BITS +: EDGE_BITS] +
            EDGE_BITS'(signed'(tile_i.a[i*COEFF_BITS +: COEFF_BITS])) * EDGE_BITS'(start_x) +
            EDGE_BITS'(signed'(tile_i.b[i*COEFF_BITS +: COEFF_BITS])) * EDGE_BITS'(start_y);
      end
    end else if (advance) begin
`ifdef PINEDA_DEPTH
      if (mask != '0) first_q <= 1'b0;
`endif
      x_q <= row_end ? X_BITS'(tile_q.x0 >> WIDTH_LOG2) : x_q + X_BITS'(1);
      y_q <= row_end ? y_q + Y_BITS'(1) : y_q;
      for (int unsigned i = 0; i < 3; i++) begin
        if (!row_end) begin
          tile_q.e[i*EDGE_BITS +: EDGE_BITS] <=
              tile_q.e[i*EDGE_BITS +: EDGE_BITS] +
              (EDGE_BITS'(signed'(tile_q.a[i*COEFF_BITS +: COEFF_BITS])) << WIDTH_LOG2);
        end else begin
          tile_q.e[i*EDGE_BITS +: EDGE_BITS] <=
              row_e_q[i*EDGE_BITS +: EDGE_BITS] +
              (EDGE_BITS'(signed'(tile_q.b[i*COEFF_BITS +: COEFF_BITS])) << HEIGHT_LOG2);
          row_e_q[i*EDGE_BITS +: EDGE_BITS] <=
              row_e_q[i*EDGE_BITS +: EDGE_BITS] +
              (EDGE_BITS'(signed'(tile_q.b[i*COEFF_BITS +: COEFF_BITS])) << HEIGHT_LOG2);
        end
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (busy_q && out_free && mask != '0) begin
      stamp_q.id <= tile_q.id;
      stamp_q.x <= (STAMP_X_BITS'(tile_q.x) << (TILE_LOG2 - WIDTH_LOG2)) + STAMP_X_BITS'(x_q);
      stamp_q.y <= (STAMP_Y_BITS'(tile_q.y) << (TILE_LOG2 - HEIGHT_LOG2)) + STAMP_Y_BITS'(y_q);
      stamp_q.mask <= mask;
`ifdef PINEDA_DEPTH
      stamp_q.first <= first_q;
      stamp_q.z_dx <= tile_q.z_dx;
      stamp_q.z_dy <= tile_q.z_dy;
      stamp_q.z_ref <= tile_q.z_ref;
      stamp_q.z_bias <= tile_q.z_bias;
`endif
`ifdef PINEDA_AFFINE
      stamp_q.attr_dx <= tile_q.attr_dx;
      stamp_q.attr_dy <= tile_q.attr_dy;
      stamp_q.attr_ref <= tile_q.attr_ref;
`endif
`ifdef PINEDA_PERSPECTIVE
      stamp_q.a <= tile_q.a;
      stamp_q.b <= tile_q.b;
      stamp_q.e <= tile_e_q;
      stamp_q.e_low <= tile_q.e_low;
      stamp_q.inverse_w <= tile_q.inverse_w;
      stamp_q.inverse_w_shift <= tile_q.inverse_w_shift;
      stamp_q.vertex_attr <= tile_q.vertex_attr;
`endif
`ifdef PINEDA_FLAT_ATTRIBUTES
      stamp_q.flat <= tile_q.flat;
`endif
    end
  end

`ifdef PINEDA_COUNTERS
  cycle_counters #(.Kinds(cycle_cause_pkg::CAUSES)) u_cycles (
    .clk_i, .count_i(1'b1),
    .kind_i(!busy_q ? cycle_cause_pkg::STARVED :
            advance ? cycle_cause_pkg::BUSY : cycle_cause_pkg::BLOCKED)
  );
  // Stamps sent, by covered samples
  cycle_counters #(.Kinds(LANES + 1)) u_sent (
    .clk_i, .count_i(stamp_valid_q && stamp_ready_i),
    .kind_i($clog2(LANES + 1)'($countones(stamp_q.mask)))
  );
`endif
endmodule
