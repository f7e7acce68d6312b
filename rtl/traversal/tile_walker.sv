// The tiles of a triangle's box, row by row from the top, along its edges.
//
// Bits     core::TileWalk defines them, and the walk. Reject: one edge is negative at that edge's best corner
//          sample of the tile. Accept, an edge at a time: it is >= 0 at its worst corner sample.
//          Hidden: core::depth_floor() of the triangle there lies behind z_max_i, as it is in the
//          first cycle of the tile's test.
// In       prim_i. hides_i: the frame's depth function lets tiles be hidden; z_max_i: the greatest
//          depth stored in tile tile_x_o, tile_y_o, the top bits.
// Out      tile_o: a tile that no edge rejects and that is not hidden, its edges and planes
//          referred to its first sample.
// Rate     one tile test a cycle, as long as kept tiles are taken; from one triangle to the next
//          without a bubble, unless PRIM_FIFO_DEPTH is 0 or hierarchical z hides tiles.
// Twin     model/core/traversal.cpp.
module tile_walker (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  input  logic                     prim_valid_i,
  output logic                     prim_ready_o,
  input  pineda_pkg::setup_prim_t  prim_i,

`ifdef PINEDA_HIERARCHICAL_Z
  input  logic                                        hides_i,
  input  logic [pineda_pkg::HIERARCHICAL_Z_BITS-1:0]  z_max_i,
  output logic [pineda_pkg::TILE_INDEX_BITS-1:0]      tile_x_o,
  output logic [pineda_pkg::TILE_INDEX_BITS-1:0]      tile_y_o,
`endif

  output logic                     tile_valid_o,
  input  logic                     tile_ready_i,
  output pineda_pkg::tile_t        tile_o,

  output logic                     busy_o
);
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
  localparam int unsigned EDGE_BITS = pineda_pkg::EDGE_BITS;
  localparam int unsigned TILE_EDGE_BITS = pineda_pkg::TILE_EDGE_BITS;
  localparam int unsigned TILE_LOG2 = pineda_pkg::TILE_LOG2;
  localparam int unsigned INDEX_BITS = pineda_pkg::TILE_INDEX_BITS;
  localparam int unsigned PIXEL_BITS = pineda_pkg::PIXEL_BITS;
`ifdef PINEDA_DEPTH
  localparam int unsigned Z_BITS = pineda_pkg::DEPTH_PLANE_BITS;
  localparam int unsigned TILE_Z_BITS = pineda_pkg::DEPTH_TILE_PLANE_BITS;
`endif
`ifdef PINEDA_AFFINE
  localparam int unsigned ATTRIBUTES = pineda_pkg::ATTRIBUTES;
  localparam int unsigned ATTR_BITS = pineda_pkg::ATTR_PLANE_BITS;
  localparam int unsigned TILE_ATTR_BITS = pineda_pkg::ATTR_TILE_PLANE_BITS;
`endif
`ifdef PINEDA_PLANES
  localparam int unsigned NARROWING =
      pineda_pkg::GRADIENT_FRACTION_BITS - pineda_pkg::TILE_FRACTION_BITS;
  // Planes inside a tile carry fewer fraction bits. Rounding, halves up, adds the last bit cut off.
  localparam int unsigned LAST_CUT = NARROWING > 0 ? NARROWING - 1 : 0;
`endif

  logic busy_q;
  pineda_pkg::setup_prim_t prim_q; // its e and refs are those of the tile under test
  logic [INDEX_BITS-1:0] x_q, y_q;
  // Where the row starts, further on by tiles that are outside in the rows below too
  logic [INDEX_BITS-1:0] start_x_q;
  logic [3*EDGE_BITS-1:0] start_e_q;
`ifdef PINEDA_DEPTH
  logic [Z_BITS-1:0] start_z_q;
`endif
`ifdef PINEDA_AFFINE
  logic [ATTRIBUTES*ATTR_BITS-1:0] start_attr_q;
`endif
  logic leftward_q; // the row is walked to the left
  logic at_start_q; // the start is this tile
  logic past_q;     // the tile before lay past the triangle: the row ends with this one

  logic [INDEX_BITS-1:0] first_x, last_x, last_y;
  assign first_x = prim_q.x0[PIXEL_BITS-1:TILE_LOG2];
  assign last_x = prim_q.x1[PIXEL_BITS-1:TILE_LOG2];
  assign last_y = prim_q.y1[PIXEL_BITS-1:TILE_LOG2];

  logic row_end, last_tile, rejected, hidden, dropped, advance;
  assign row_end = past_q || x_q == (leftward_q ? first_x : last_x);
  assign last_tile = row_end && y_q == last_y;
  assign dropped = rejected || hidden;
  assign advance = busy_q && (dropped || tile_ready_i);
  assign tile_valid_o = busy_q && !dropped;
  assign busy_o = busy_q;
  // No path leads from the test to the unit in front if there is no FIFO between, nor from depths.
`ifdef PINEDA_HIERARCHICAL_Z
  assign prim_ready_o = !busy_q;
`else
  assign prim_ready_o = !busy_q || (pineda_pkg::PRIM_FIFO_DEPTH > 0 && advance && last_tile);
`endif

  // ---- The test. From the tile's first sample to its last it is 2^TILE_LOG2 - 1 px; each sum is
  // an E' at a corner sample, so it fits.
  function automatic logic signed [EDGE_BITS-1:0] across(input logic [COEFF_BITS-1:0] coeff);
    across = (EDGE_BITS'(signed'(coeff)) <<< TILE_LOG2) - EDGE_BITS'(signed'(coeff));
  endfunction

  logic [2:0] rejects, accepts;
  for (genvar i = 0; i < 3; i++) begin : gen_edges
    logic signed [EDGE_BITS-1:0] e, a, b, best, worst;
    assign e = EDGE_BITS'(signed'(prim_q.e[i*EDGE_BITS +: EDGE_BITS]));
    assign a = across(prim_q.a[i*COEFF_BITS +: COEFF_BITS]);
    assign b = across(prim_q.b[i*COEFF_BITS +: COEFF_BITS]);
    assign best = e + (a > 0 ? a : '0) + (b > 0 ? b : '0);
    assign worst = e + (a < 0 ? a : '0) + (b < 0 ? b : '0);
    assign rejects[i] = best < 0;
    assign accepts[i] = worst >= 0;
  end
  assign rejected = rejects != '0;

`ifdef PINEDA_DEPTH
  function automatic logic [TILE_Z_BITS-1:0] narrow_z(input logic [Z_BITS-1:0] value);
    narrow_z = value[Z_BITS-1:NARROWING];
    if (NARROWING > 0) narrow_z = narrow_z + TILE_Z_BITS'(value[LAST_CUT]);
  endfunction
`endif

`ifdef PINEDA_HIERARCHICAL_Z
  // The least depth code of the tile is that of the plane at the corner where it is least. A steep
  // plane may have wrapped, so nothing is known about its codes.
  logic fresh_q; // the tile's first cycle
  logic signed [TILE_Z_BITS-1:0] least_dx, least_dy, least;
  logic [pineda_pkg::HIERARCHICAL_Z_BITS-1:0] floor;
  logic [pineda_pkg::DEPTH_BITS-1:0] code_unused;  // but for its upper bits
  assign tile_x_o = x_q;
  assign tile_y_o = y_q;
  assign least_dx = signed'(narrow_z(prim_q.z_dx));
  assign least_dy = signed'(narrow_z(prim_q.z_dy));
  assign least = signed'(narrow_z(prim_q.z_ref)) +
                 (least_dx < 0 ? (least_dx <<< TILE_LOG2) - least_dx : '0) +
                 (least_dy < 0 ? (least_dy <<< TILE_LOG2) - least_dy : '0);
  depth_code u_floor (
    .value_i(least), .bias_i(prim_q.z_bias), .code_o(code_unused)
  );
  assign floor = code_unused[pineda_pkg::DEPTH_BITS-1 -: pineda_pkg::HIERARCHICAL_Z_BITS];
  assign hidden = busy_q && fresh_q && hides_i && !prim_q.z_steep && !rejected && floor > z_max_i;
  always_ff @(posedge clk_i) fresh_q <= (prim_valid_i && prim_ready_o) || advance;
`else
  assign hidden = 1'b0;
`endif

  // ---- The tile. While it is not valid its payload is not used, so it is 'x then: that costs no
  // gate and saves the simulator work.
`ifdef PINEDA_AFFINE
  function automatic logic [TILE_ATTR_BITS-1:0] narrow_attr(input logic [ATTR_BITS-1:0] value);
    narrow_attr = value[ATTR_BITS-1:NARROWING];
    if (NARROWING > 0) narrow_attr = narrow_attr + TILE_ATTR_BITS'(value[LAST_CUT]);
  endfunction
`endif

  always_comb begin
    tile_o = 'x;
    if (tile_valid_o) begin
      tile_o.id = prim_q.id;
      tile_o.x = x_q;
      tile_o.y = y_q;
      tile_o.x0 = x_q == first_x ? prim_q.x0[TILE_LOG2-1:0] : '0;
      tile_o.y0 = y_q == prim_q.y0[PIXEL_BITS-1:TILE_LOG2] ? prim_q.y0[TILE_LOG2-1:0] : '0;
      tile_o.x1 = x_q == last_x ? prim_q.x1[TILE_LOG2-1:0] : '1;
      tile_o.y1 = y_q == last_y ? prim_q.y1[TILE_LOG2-1:0] : '1;
      tile_o.a = prim_q.a;
      tile_o.b = prim_q.b;
      tile_o.accepted = accepts;
      for (int unsigned i = 0; i < 3; i++) begin
        tile_o.e[i*TILE_EDGE_BITS +: TILE_EDGE_BITS] =
            prim_q.e[i*EDGE_BITS +: TILE_EDGE_BITS];
      end
`ifdef PINEDA_DEPTH
      tile_o.z_dx = narrow_z(prim_q.z_dx);
      tile_o.z_dy = narrow_z(prim_q.z_dy);
      tile_o.z_ref = narrow_z(prim_q.z_ref);
      tile_o.z_bias = prim_q.z_bias;
`endif
`ifdef PINEDA_AFFINE
      for (int unsigned i = 0; i < ATTRIBUTES; i++) begin
        tile_o.attr_dx[i*TILE_ATTR_BITS +: TILE_ATTR_BITS] =
            narrow_attr(prim_q.attr_dx[i*ATTR_BITS +: ATTR_BITS]);
        tile_o.attr_dy[i*TILE_ATTR_BITS +: TILE_ATTR_BITS] =
            narrow_attr(prim_q.attr_dy[i*ATTR_BITS +: ATTR_BITS]);
        tile_o.attr_ref[i*TILE_ATTR_BITS +: TILE_ATTR_BITS] =
            narrow_attr(prim_q.attr_ref[i*ATTR_BITS +: ATTR_BITS]);
      end
`endif
`ifdef PINEDA_PERSPECTIVE
      tile_o.e_low = prim_q.e_low;
      tile_o.inverse_w = prim_q.inverse_w;
      tile_o.inverse_w_shift = prim_q.inverse_w_shift;
      tile_o.vertex_attr = prim_q.vertex_attr;
`endif
`ifdef PINEDA_FLAT_ATTRIBUTES
      tile_o.flat = prim_q.flat;
`endif
    end
  end

  // ---- The walk: one tile to the right or left, or down to where the next row starts. Edges fall to
  // the right where a < 0, downwards where b <= 0.
  logic [2:0] falls_ahead, falls_down, falls_right;
  for (genvar i = 0; i < 3; i++) begin : gen_falls
    logic [COEFF_BITS-1:0] b;
    assign b = prim_q.b[i*COEFF_BITS +: COEFF_BITS];
    assign falls_right[i] = prim_q.a[i*COEFF_BITS + COEFF_BITS - 1];
    assign falls_down[i] = b[COEFF_BITS-1] || b == '0;
    assign falls_ahead[i] = falls_right[i] != leftward_q;
  end
  // Both sides run down to the left: the first row is walked to its end, the others back from there.
  logic turns, to_the_end, start_follows;
  assign turns = (~falls_right & ~falls_down) != '0 && (falls_right & falls_down) != '0;
  assign to_the_end = turns && !leftward_q;
  assign start_follows =
      at_start_q && (to_the_end || (rejects & ~falls_ahead & falls_down) != '0);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) busy_q <= 1'b0;
    else if (!busy_q || (advance && last_tile)) busy_q <= prim_valid_i && prim_ready_o;
  end

  // From this tile, or from the row's start, by the same adders
  logic back; // against dx
  logic [INDEX_BITS-1:0] next_x;
  assign back = leftward_q && !row_end;
  assign next_x = row_end ? start_x_q : back ? x_q - INDEX_BITS'(1) : x_q + INDEX_BITS'(1);
  logic [3*EDGE_BITS-1:0] next_e;
  for (genvar i = 0; i < 3; i++) begin : gen_next_e
    localparam int unsigned HIGH = EDGE_BITS - TILE_LOG2; // bits that move
    logic [EDGE_BITS-1:0] from;
    logic signed [HIGH-1:0] step;
    assign from = row_end ? start_e_q[i*EDGE_BITS +: EDGE_BITS] : prim_q.e[i*EDGE_BITS +: EDGE_BITS];
    assign step = HIGH'(signed'(row_end ? prim_q.b[i*COEFF_BITS +: COEFF_BITS]
                                        : prim_q.a[i*COEFF_BITS +: COEFF_BITS]));
    assign next_e[i*EDGE_BITS +: EDGE_BITS] =
        {from[EDGE_BITS-1:TILE_LOG2] + (step ^ {HIGH{back}}) + HIGH'(back), from[TILE_LOG2-1:0]};
  end
`ifdef PINEDA_DEPTH
  localparam int unsigned Z_HIGH = Z_BITS - TILE_LOG2;
  logic [Z_BITS-1:0] from_z, next_z;
  logic [Z_HIGH-1:0] step_z;
  assign from_z = row_end ? start_z_q : prim_q.z_ref;
  assign step_z = row_end ? prim_q.z_dy[Z_HIGH-1:0] : prim_q.z_dx[Z_HIGH-1:0];
  assign next_z = {from_z[Z_BITS-1:TILE_LOG2] + (step_z ^ {Z_HIGH{back}}) + Z_HIGH'(back),
                   from_z[TILE_LOG2-1:0]};
`endif
`ifdef PINEDA_AFFINE
  localparam int unsigned ATTR_HIGH = ATTR_BITS - TILE_LOG2;
  logic [ATTRIBUTES*ATTR_BITS-1:0] next_attr;
  for (genvar i = 0; i < ATTRIBUTES; i++) begin : gen_next_attr
    logic [ATTR_BITS-1:0] from;
    logic [ATTR_HIGH-1:0] step;
    assign from = row_end ? start_attr_q[i*ATTR_BITS +: ATTR_BITS]
                          : prim_q.attr_ref[i*ATTR_BITS +: ATTR_BITS];
    assign step = row_end ? prim_q.attr_dy[i*ATTR_BITS +: ATTR_HIGH]
                          : prim_q.attr_dx[i*ATTR_BITS +: ATTR_HIGH];
    assign next_attr[i*ATTR_BITS +: ATTR_BITS] =
        {from[ATTR_BITS-1:TILE_LOG2] + (step ^ {ATTR_HIGH{back}}) + ATTR_HIGH'(back),
         from[TILE_LOG2-1:0]};
  end
`endif

  always_ff @(posedge clk_i) begin
    if (prim_valid_i && prim_ready_o) begin
      prim_q <= prim_i;
      x_q <= prim_i.x0[PIXEL_BITS-1:TILE_LOG2];
      y_q <= prim_i.y0[PIXEL_BITS-1:TILE_LOG2];
      leftward_q <= 1'b0;
      at_start_q <= 1'b1;
      past_q <= 1'b0;
      start_x_q <= prim_i.x0[PIXEL_BITS-1:TILE_LOG2];
      start_e_q <= prim_i.e;
`ifdef PINEDA_DEPTH
      start_z_q <= prim_i.z_ref;
`endif
`ifdef PINEDA_AFFINE
      start_attr_q <= prim_i.attr_ref;
`endif
    end else if (advance) begin
      x_q <= next_x;
      if (row_end) begin
        y_q <= y_q + INDEX_BITS'(1);
        leftward_q <= turns;
      end
      at_start_q <= row_end || start_follows;
      past_q <= !row_end && !to_the_end && (rejects & falls_ahead) != '0;
      prim_q.e <= next_e;
`ifdef PINEDA_DEPTH
      prim_q.z_ref <= next_z;
`endif
`ifdef PINEDA_AFFINE
      prim_q.attr_ref <= next_attr;
`endif
      if (row_end || start_follows) begin
        start_x_q <= next_x;
        start_e_q <= next_e;
`ifdef PINEDA_DEPTH
        start_z_q <= next_z;
`endif
`ifdef PINEDA_AFFINE
        start_attr_q <= next_attr;
`endif
      end
    end
  end

`ifdef PINEDA_COUNTERS
  cycle_counters #(.Kinds(cycle_cause_pkg::CAUSES)) u_cycles (
    .clk_i, .count_i(1'b1),
    .kind_i(!busy_q ? cycle_cause_pkg::STARVED :
            advance ? cycle_cause_pkg::BUSY : cycle_cause_pkg::BLOCKED)
  );
  // What came of a test: 0 the tile is kept, 1 accepted by all edges too, 2 rejected, 3 hidden
  cycle_counters #(.Kinds(4)) u_tests (
    .clk_i, .count_i(advance),
    .kind_i(rejected ? 2'd2 : hidden ? 2'd3 : accepts == '1 ? 2'd1 : 2'd0)
  );
`endif
endmodule
