// Interpolation and depth test: one stamp in, its depth and colour writes out, in order.
//
// Bits     core::interpolate_depth(), core::depth_test() and core::interpolate_attributes() define
//          every output bit.
// In       stamp_i; depth_func_i, depth_write_i: stable while any stamp of the frame is inside.
// Out      depth_wr_o, color_wr_o: the covered samples that pass; nothing if none does. With the
//          test off, or depth not to be written, colour only.
// Rate     a stamp a cycle at any read latency up to INFLIGHT_STAMPS - 4 cycles, as long as no
//          hazard and no port stalls it and there is a slot for the planes of one more tile: a
//          tile's are kept until the first stamp of the next tile is loaded into the write register.
//          A stamp whose address is in flight waits. In flight = from the read accepted to the
//          depth write accepted, or to the cycle in which that write would have been offered: time
//          does not depend on depth. A read of the address may be accepted in the cycle after.
//          Attributes are interpolated where a sample passed, and follow ATTRIBUTE_CYCLES later. A
//          design without depth has no table: every stamp goes from the FIFO in front to its
//          colour write.
// Drops    samples that fail the test.
// Errors   none.
// Twin     model/core/interp.cpp.
module interp_ztest_unit (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  // Stamps, from traversal_unit
  input  logic                      stamp_valid_i,
  output logic                      stamp_ready_o,
  input  pineda_pkg::stamp_t        stamp_i,

`ifdef PINEDA_DEPTH
  // Raster state
  input  logic [3:0]                depth_func_i,
  input  logic                      depth_write_i,

`ifdef PINEDA_HIERARCHICAL_Z
  // All samples of a stamp in the frame are read, so that its greatest depth is known when its
  // depth write is accepted
  input  logic [pineda_pkg::FRAME_SIZE_BITS-1:0] frame_width_i,
  input  logic [pineda_pkg::FRAME_SIZE_BITS-1:0] frame_height_i,
  output logic                      depth_max_valid_o,
  output pineda_pkg::depth_max_t    depth_max_o,
`endif

  // Depth memory: responses come in the order of the requests; they and the writes are stable while
  // valid && !ready
  output logic                      depth_rd_valid_o,
  input  logic                      depth_rd_ready_i,
  output pineda_pkg::depth_read_t   depth_rd_o,
  input  logic                      depth_rsp_valid_i,
  output logic                      depth_rsp_ready_o,
  input  pineda_pkg::depth_data_t   depth_rsp_i,
  output logic                      depth_wr_valid_o,
  input  logic                      depth_wr_ready_i,
  output pineda_pkg::depth_write_t  depth_wr_o,
`endif

  // Colour memory; stable while valid && !ready
  output logic                      color_wr_valid_o,
  input  logic                      color_wr_ready_i,
  output pineda_pkg::color_write_t  color_wr_o,

  output logic                      idle_o
);
  localparam int unsigned LANES = pineda_pkg::LANES;
`ifdef PINEDA_PERSPECTIVE
  localparam int unsigned COEFF_BITS = pineda_pkg::EDGE_COEFF_BITS;
`endif
`ifdef PINEDA_DEPTH
`define PINEDA_PLACES
`elsif PINEDA_ATTRIBUTES
`define PINEDA_PLACES
`endif
`ifdef PINEDA_PLACES
  // A stamp's place inside its tile; 0 where a tile is a stamp wide or high
  localparam int unsigned COLUMN_BITS = pineda_pkg::STAMP_COLUMN_BITS;
  localparam int unsigned ROW_BITS = pineda_pkg::STAMP_ROW_BITS;
  localparam logic HAS_COLUMNS = pineda_pkg::TILE_LOG2 > pineda_pkg::STAMP_WIDTH_LOG2;
  localparam logic HAS_ROWS = pineda_pkg::TILE_LOG2 > pineda_pkg::STAMP_HEIGHT_LOG2;
`endif

`ifdef PINEDA_DEPTH
  // What all stamps of a tile share, for their depths
  typedef struct packed {
    logic [pineda_pkg::DEPTH_TILE_PLANE_BITS-1:0] z_dx;
    logic [pineda_pkg::DEPTH_TILE_PLANE_BITS-1:0] z_dy;
    logic [pineda_pkg::DEPTH_TILE_PLANE_BITS-1:0] z_ref;
    logic [pineda_pkg::DEPTH_BIAS_BITS-1:0]       z_bias;
  } depths_t;
  depths_t depths_in, depths_q;
  assign depths_in.z_dx = stamp_i.z_dx;
  assign depths_in.z_dy = stamp_i.z_dy;
  assign depths_in.z_ref = stamp_i.z_ref;
  assign depths_in.z_bias = stamp_i.z_bias;
`endif

  // The same for their colours, with the triangle's number
  typedef struct packed {
    logic [pineda_pkg::ID_BITS-1:0]      id;
`ifdef PINEDA_AFFINE
    logic [pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_TILE_PLANE_BITS-1:0] attr_dx;
    logic [pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_TILE_PLANE_BITS-1:0] attr_dy;
    logic [pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_TILE_PLANE_BITS-1:0] attr_ref;
`endif
`ifdef PINEDA_PERSPECTIVE
    logic [3*COEFF_BITS-1:0]                      a;
    logic [3*COEFF_BITS-1:0]                      b;
    logic [3*pineda_pkg::EDGE_BITS-1:0]           e;
    logic [3*pineda_pkg::SUBPIXEL_BITS-1:0]       e_low;
    logic [3*pineda_pkg::INVERSE_W_BITS-1:0]      inverse_w;
    logic [3*pineda_pkg::INVERSE_W_SHIFT_BITS-1:0] inverse_w_shift;
    logic [3*pineda_pkg::ATTRIBUTES*pineda_pkg::ATTR_BITS-1:0] vertex_attr;
`endif
`ifdef PINEDA_FLAT_ATTRIBUTES
    logic [pineda_pkg::FLAT_ATTRIBUTES*pineda_pkg::ATTR_BITS-1:0] flat;
`endif
  } colors_t;
  colors_t colors_in, colors;
  assign colors_in.id = stamp_i.id;
`ifdef PINEDA_AFFINE
  assign colors_in.attr_dx = stamp_i.attr_dx;
  assign colors_in.attr_dy = stamp_i.attr_dy;
  assign colors_in.attr_ref = stamp_i.attr_ref;
`endif
`ifdef PINEDA_PERSPECTIVE
  assign colors_in.a = stamp_i.a;
  assign colors_in.b = stamp_i.b;
  assign colors_in.e = stamp_i.e;
  assign colors_in.e_low = stamp_i.e_low;
  assign colors_in.inverse_w = stamp_i.inverse_w;
  assign colors_in.inverse_w_shift = stamp_i.inverse_w_shift;
  assign colors_in.vertex_attr = stamp_i.vertex_attr;
`endif
`ifdef PINEDA_FLAT_ATTRIBUTES
  assign colors_in.flat = stamp_i.flat;
`endif

  // What differs from stamp to stamp
  typedef struct packed {
    logic [pineda_pkg::STAMP_X_BITS-1:0] x;
    logic [pineda_pkg::STAMP_Y_BITS-1:0] y;
    logic [LANES-1:0]                    mask;
    logic                                first; // of its tile
  } place_t;
  place_t place_in, next, head;
  assign place_in.x = stamp_i.x;
  assign place_in.y = stamp_i.y;
  assign place_in.mask = stamp_i.mask;
  assign place_in.first = stamp_i.first;

  // A stamp is loaded into the write register, from where its depth and its colours leave.
  logic load, write_free;
  logic [LANES-1:0] passed;
  logic color_pending_q, colors_ready;
  logic [pineda_pkg::ID_BITS-1:0] id_q;
  logic [pineda_pkg::STAMP_X_BITS-1:0] x_q;
  logic [pineda_pkg::STAMP_Y_BITS-1:0] y_q;
  logic [LANES-1:0] mask_q;

  // ---- Planes are kept once for all stamps of a tile: from when its first stamp comes until the
  // first one of the next tile is loaded.
  localparam int unsigned SLOTS = pineda_pkg::PLANE_SLOTS;
  localparam int unsigned SLOT_BITS = $clog2(SLOTS);
  // Of the newest tile: the last one and the next; of the stamp that is loaded
  logic [SLOT_BITS-1:0] newest_q, newest, head_slot;
  logic [SLOT_BITS-1:0] tiles_q; // whose first stamp is not loaded yet
  logic push, room;
  function automatic logic [SLOT_BITS-1:0] after(input logic [SLOT_BITS-1:0] slot);
    after = slot == SLOT_BITS'(SLOTS - 1) ? '0 : slot + SLOT_BITS'(1);
  endfunction
  assign newest = after(newest_q);
  assign room = tiles_q != SLOT_BITS'(SLOTS - 1);
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      newest_q <= '0;
      tiles_q <= '0;
    end else begin
      if (push && stamp_i.first) newest_q <= newest;
      tiles_q <= tiles_q + SLOT_BITS'(push && stamp_i.first) - SLOT_BITS'(load && head.first);
    end
  end
  // Memories of plain vectors: Yosys 0.23 drops one of structs without a word.
  logic [$bits(colors_in)-1:0] colors_mem [SLOTS];
  always_ff @(posedge clk_i) begin
    if (push && stamp_i.first) colors_mem[newest] <= colors_in;
  end
  assign colors = colors_mem[head_slot];

  // ---- Stamps that wait
  logic queue_ready, next_valid, next_ready;
  logic [pineda_pkg::ID_BITS-1:0] next_id;
  assign stamp_ready_o = queue_ready && room;
  assign push = stamp_valid_i && stamp_ready_o;
  stream_fifo #(
    .Width(pineda_pkg::ID_BITS + $bits(place_in)), .Depth(pineda_pkg::STAMP_FIFO_DEPTH)
  ) u_stamps (
    .clk_i, .rst_ni,
    .in_valid_i(push), .in_ready_o(queue_ready), .in_data_i({stamp_i.id, place_in}),
    .out_valid_o(next_valid), .out_ready_i(next_ready), .out_data_o({next_id, next})
  );

`ifdef PINEDA_DEPTH
  localparam int unsigned Z_BITS = pineda_pkg::DEPTH_BITS;
  localparam int unsigned INFLIGHT = pineda_pkg::INFLIGHT_STAMPS;
  localparam int unsigned ADDRESS_BITS = pineda_pkg::STAMP_X_BITS + pineda_pkg::STAMP_Y_BITS;

  // Raster state, so that no path leads from it to a port
  logic [3:0] func_q;
  logic write_q, test;
  assign test = func_q != pineda_pkg::DEPTH_OFF;
  always_ff @(posedge clk_i) begin
    func_q <= depth_func_i;
    write_q <= depth_write_i;
  end
`ifdef PINEDA_HIERARCHICAL_Z
  logic [pineda_pkg::FRAME_SIZE_BITS-1:0] frame_width_q, frame_height_q;
  always_ff @(posedge clk_i) begin
    frame_width_q <= frame_width_i;
    frame_height_q <= frame_height_i;
  end
`endif

  // ---- Issue: a stamp enters when no stamp ahead of it can still write what it reads
  logic hazard, table_full, table_empty, accept, retire;
  assign depth_rd_valid_o = next_valid && test && !hazard && !table_full;
  assign next_ready = !hazard && !table_full && (!test || depth_rd_ready_i);
  assign accept = next_valid && next_ready;
  assign depth_rd_o.id = next_id;
  assign depth_rd_o.x = next.x;
  assign depth_rd_o.y = next.y;
`ifdef PINEDA_HIERARCHICAL_Z
  for (genvar lane = 0; lane < LANES; lane++) begin : gen_read
    localparam int unsigned COLUMN = lane % (1 << pineda_pkg::STAMP_WIDTH_LOG2);
    localparam int unsigned ROW = lane >> pineda_pkg::STAMP_WIDTH_LOG2;
    localparam int unsigned SIZE_BITS = pineda_pkg::FRAME_SIZE_BITS;
    assign depth_rd_o.mask[lane] =
        (SIZE_BITS'(next.x) << pineda_pkg::STAMP_WIDTH_LOG2) + SIZE_BITS'(COLUMN) <
            frame_width_q &&
        (SIZE_BITS'(next.y) << pineda_pkg::STAMP_HEIGHT_LOG2) + SIZE_BITS'(ROW) <
            frame_height_q;
  end
`else
  assign depth_rd_o.mask = next.mask;
`endif

  // ---- Stamps on their way to the test: their addresses stand in the table, the rest beside it.
  // Depths are interpolated ahead of the test.
  localparam int unsigned PTR_BITS = $clog2(INFLIGHT);
  localparam int unsigned COUNT_BITS = $clog2(INFLIGHT + 1);
  logic z_start, z_ready, z_valid_q;
  place_t next_place;
  logic [PTR_BITS-1:0] newest_place, z_place_q;
  logic [COUNT_BITS-1:0] places_q; // accepted, their depths not started
  function automatic logic [PTR_BITS-1:0] behind(input logic [PTR_BITS-1:0] place);
    behind = place == PTR_BITS'(INFLIGHT - 1) ? '0 : place + PTR_BITS'(1);
  endfunction
  assign z_start = places_q != '0 && (!z_valid_q || z_ready);
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      z_place_q <= '0;
      places_q <= '0;
    end else begin
      if (z_start) z_place_q <= behind(z_place_q);
      places_q <= places_q + COUNT_BITS'(accept) - COUNT_BITS'(z_start);
    end
  end
  inflight_table #(.Width(ADDRESS_BITS), .Depth(INFLIGHT)) u_inflight (
    .clk_i, .rst_ni,
    .lookup_i(next_valid && test),
    .address_i({next.y, next.x}),
    .hit_o(hazard),
    .full_o(table_full),
    .empty_o(table_empty),
    .insert_i(accept), .insert_at_o(newest_place),
    .remove_i(retire),
    .place_i(z_place_q), .address_o({next_place.y, next_place.x})
  );
  logic [LANES:0] places_mem [INFLIGHT];
  always_ff @(posedge clk_i) begin
    if (accept) places_mem[newest_place] <= {next.first, next.mask};
  end
  assign {next_place.first, next_place.mask} = places_mem[z_place_q];

  // ---- Depths: where the stamp is, and its planes
  logic [$bits(depths_in)-1:0] depths_mem [SLOTS];
  place_t stamp_q; // whose depths are interpolated, and its slot
  logic [SLOT_BITS-1:0] stamp_slot, stamp_slot_q;
  assign stamp_slot = next_place.first ? after(stamp_slot_q) : stamp_slot_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      z_valid_q <= 1'b0;
      stamp_slot_q <= '0;
    end else if (!z_valid_q || z_ready) begin
      z_valid_q <= z_start;
      if (z_start) stamp_slot_q <= stamp_slot;
    end
  end
  always_ff @(posedge clk_i) begin
    if (z_start) {stamp_q, depths_q} <= {next_place, depths_mem[stamp_slot]};
  end
  always_ff @(posedge clk_i) begin
    if (push && stamp_i.first) depths_mem[newest] <= depths_in;
  end

  logic head_z_valid, rsp_valid;
  logic [LANES*Z_BITS-1:0] head_z;
  pineda_pkg::depth_data_t stored;
  depth_interpolator #(.TagBits($bits(stamp_q) + SLOT_BITS)) u_depth (
    .clk_i, .rst_ni,
    .stamp_valid_i(z_valid_q), .stamp_ready_o(z_ready),
    .column_i(COLUMN_BITS'(stamp_q.x) & {COLUMN_BITS{HAS_COLUMNS}}),
    .row_i(ROW_BITS'(stamp_q.y) & {ROW_BITS{HAS_ROWS}}), .mask_i(stamp_q.mask),
    .z_dx_i(depths_q.z_dx), .z_dy_i(depths_q.z_dy), .z_ref_i(depths_q.z_ref), .z_bias_i(depths_q.z_bias),
    .tag_i({stamp_q, stamp_slot_q}),
    .z_valid_o(head_z_valid), .z_ready_i(load), .tag_o({head, head_slot}), .z_o(head_z)
  );
  // So that a response does not wait for a write to be taken in the same cycle
  stream_fifo #(.Width(pineda_pkg::DEPTH_DATA_BITS), .Depth(2)) u_responses (
    .clk_i, .rst_ni,
    .in_valid_i(depth_rsp_valid_i), .in_ready_o(depth_rsp_ready_o), .in_data_i(depth_rsp_i),
    .out_valid_o(rsp_valid), .out_ready_i(load && test), .out_data_o(stored)
  );
  assign load = head_z_valid && (rsp_valid || !test) && write_free;

  // ---- Depth test: which outcomes of the comparison pass
  logic pass_less, pass_equal, pass_greater;
  always_comb begin
    case (func_q)
      pineda_pkg::DEPTH_LESS:     {pass_less, pass_equal, pass_greater} = 3'b100;
      pineda_pkg::DEPTH_LEQUAL:   {pass_less, pass_equal, pass_greater} = 3'b110;
      pineda_pkg::DEPTH_NEVER:    {pass_less, pass_equal, pass_greater} = 3'b000;
      pineda_pkg::DEPTH_EQUAL:    {pass_less, pass_equal, pass_greater} = 3'b010;
      pineda_pkg::DEPTH_GREATER:  {pass_less, pass_equal, pass_greater} = 3'b001;
      pineda_pkg::DEPTH_NOTEQUAL: {pass_less, pass_equal, pass_greater} = 3'b101;
      pineda_pkg::DEPTH_GEQUAL:   {pass_less, pass_equal, pass_greater} = 3'b011;
      default:                    {pass_less, pass_equal, pass_greater} = 3'b111; // off, always
    endcase
  end
  always_comb begin
    passed = 'x;
    if (head_z_valid) begin
      for (int unsigned i = 0; i < LANES; i++) begin
        if (head_z[i*Z_BITS +: Z_BITS] < stored.z[i*Z_BITS +: Z_BITS]) passed[i] = pass_less;
        else if (head_z[i*Z_BITS +: Z_BITS] == stored.z[i*Z_BITS +: Z_BITS]) passed[i] = pass_equal;
        else passed[i] = pass_greater;
      end
      passed = passed & head.mask;
    end
  end

  // ---- The depth write: a stamp retires with it, or in its place when there is none
  logic depth_pending_q;
  logic [LANES*Z_BITS-1:0] z_q;
  assign depth_wr_valid_o = depth_pending_q && test && write_q && mask_q != '0;
  assign retire = depth_pending_q && (!depth_wr_valid_o || depth_wr_ready_i);
  assign write_free = (!depth_pending_q || retire) && (!color_pending_q || colors_ready);
  assign depth_wr_o.id = id_q;
  assign depth_wr_o.x = x_q;
  assign depth_wr_o.y = y_q;
  assign depth_wr_o.mask = mask_q;
  assign depth_wr_o.z = z_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) depth_pending_q <= 1'b0;
    else if (load) depth_pending_q <= 1'b1;
    else if (retire) depth_pending_q <= 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (load) begin
      for (int unsigned i = 0; i < LANES; i++) begin
        z_q[i*Z_BITS +: Z_BITS] <= passed[i] ? head_z[i*Z_BITS +: Z_BITS] : '0;
      end
    end
  end

`ifdef PINEDA_HIERARCHICAL_Z
  localparam int unsigned MAX_BITS = pineda_pkg::HIERARCHICAL_Z_BITS;
  logic [MAX_BITS-1:0] greatest, greatest_q;
  always_comb begin
    greatest = '0;
    if (head_z_valid) begin
      for (int unsigned i = 0; i < LANES; i++) begin
        if (passed[i]) begin
          if (head_z[(i+1)*Z_BITS-1 -: MAX_BITS] > greatest) begin
            greatest = head_z[(i+1)*Z_BITS-1 -: MAX_BITS];
          end
        end else if (stored.z[(i+1)*Z_BITS-1 -: MAX_BITS] > greatest) begin
          greatest = stored.z[(i+1)*Z_BITS-1 -: MAX_BITS];
        end
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (load) greatest_q <= greatest;
  end
  assign depth_max_valid_o = depth_wr_valid_o && depth_wr_ready_i;
  assign depth_max_o.x = x_q;
  assign depth_max_o.y = y_q;
  assign depth_max_o.z = greatest_q;
`endif
`else
  assign next_ready = write_free;
  assign load = next_valid && write_free;
  assign head = next;
  logic [SLOT_BITS-1:0] head_slot_q;
  assign head_slot = head.first ? after(head_slot_q) : head_slot_q;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) head_slot_q <= '0;
    else if (load) head_slot_q <= head_slot;
  end
  assign passed = head.mask;
  assign write_free = !color_pending_q || colors_ready;
`endif

  // ---- The write register: what depth and colours share, and the flat attributes
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) color_pending_q <= 1'b0;
    else if (load) color_pending_q <= passed != '0;
    else if (colors_ready) color_pending_q <= 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (load) begin
      id_q <= colors.id;
      x_q <= head.x;
      y_q <= head.y;
      mask_q <= passed;
    end
  end
`ifdef PINEDA_FLAT_ATTRIBUTES
  logic [pineda_pkg::FLAT_ATTRIBUTES*pineda_pkg::ATTR_BITS-1:0] flat_q;
  always_ff @(posedge clk_i) begin
    if (load) flat_q <= colors.flat;
  end
  localparam int unsigned TOKEN_BITS = $bits(id_q) + $bits(x_q) + $bits(y_q) + LANES +
                                       $bits(flat_q);
  logic [TOKEN_BITS-1:0] token, leaving;
  assign token = {id_q, x_q, y_q, mask_q, flat_q};
  assign {color_wr_o.id, color_wr_o.x, color_wr_o.y, color_wr_o.mask, color_wr_o.flat} = leaving;
`else
  localparam int unsigned TOKEN_BITS = $bits(id_q) + $bits(x_q) + $bits(y_q) + LANES;
  logic [TOKEN_BITS-1:0] token, leaving;
  assign token = {id_q, x_q, y_q, mask_q};
  assign {color_wr_o.id, color_wr_o.x, color_wr_o.y, color_wr_o.mask} = leaving;
`endif

`ifdef PINEDA_ATTRIBUTES
  // ---- Attributes. A stamp enters when there is room behind the pipe, so the pipe never stops.
  localparam int unsigned ROOM = pineda_pkg::ATTRIBUTE_CYCLES + 1;
  localparam int unsigned ATTRS_BITS = LANES * pineda_pkg::ATTRIBUTES * pineda_pkg::ATTR_BITS;
  logic attr_valid, attr_ready, token_valid, color_valid;
  logic [ATTRS_BITS-1:0] attr;

`ifdef PINEDA_AFFINE
  attribute_interpolator u_attributes (
    .clk_i,
    .load_i(load && passed != '0),
    .column_i(COLUMN_BITS'(head.x) & {COLUMN_BITS{HAS_COLUMNS}}),
    .row_i(ROW_BITS'(head.y) & {ROW_BITS{HAS_ROWS}}),
    .attr_dx_i(colors.attr_dx), .attr_dy_i(colors.attr_dy), .attr_ref_i(colors.attr_ref),
    .start_i(color_pending_q && colors_ready), .mask_i(mask_q),
    .attr_o(attr)
  );
  assign attr_valid = color_pending_q && colors_ready;
`else
  perspective_interpolator u_attributes (
    .clk_i, .rst_ni,
    .load_i(load && passed != '0),
    .column_i(COLUMN_BITS'(head.x) & {COLUMN_BITS{HAS_COLUMNS}}),
    .row_i(ROW_BITS'(head.y) & {ROW_BITS{HAS_ROWS}}),
    .a_i(colors.a), .b_i(colors.b), .e_i(colors.e), .e_low_i(colors.e_low),
    .inverse_w_i(colors.inverse_w), .inverse_w_shift_i(colors.inverse_w_shift),
    .vertex_attr_i(colors.vertex_attr),
    .start_i(color_pending_q && colors_ready), .mask_i(mask_q),
    .attr_valid_o(attr_valid), .attr_o(attr)
  );
`endif

  stream_fifo #(.Width(ATTRS_BITS), .Depth(ROOM)) u_colors (
    .clk_i, .rst_ni,
    .in_valid_i(attr_valid), .in_ready_o(attr_ready), .in_data_i(attr),
    .out_valid_o(color_valid), .out_ready_i(token_valid && color_wr_ready_i),
    .out_data_o(color_wr_o.attr)
  );
  // Address, mask and flat attributes of each stamp that entered, from its first cycle in the pipe
  // on.
  stream_fifo #(.Width(TOKEN_BITS), .Depth(ROOM)) u_tokens (
    .clk_i, .rst_ni,
    .in_valid_i(color_pending_q), .in_ready_o(colors_ready), .in_data_i(token),
    .out_valid_o(token_valid), .out_ready_i(color_valid && color_wr_ready_i),
    .out_data_o(leaving)
  );
  assign color_wr_valid_o = token_valid && color_valid;
`else
  logic token_valid;
  assign token_valid = 1'b0;
  assign colors_ready = color_wr_ready_i;
  assign color_wr_valid_o = color_pending_q;
  assign leaving = token;
`endif

`ifdef PINEDA_DEPTH
  assign idle_o = !next_valid && table_empty && !color_pending_q && !token_valid;
`else
  assign idle_o = !next_valid && !color_pending_q && !token_valid;
`endif

`ifdef PINEDA_COUNTERS
  logic [2:0] cause;
`ifdef PINEDA_DEPTH
  assign cause = !next_valid ? cycle_cause_pkg::STARVED :
                 hazard ? cycle_cause_pkg::HAZARD :
                 table_full ? cycle_cause_pkg::BLOCKED :
                 next_ready ? cycle_cause_pkg::BUSY : cycle_cause_pkg::MEMORY;
  cycle_counters #(.Kinds(1)) u_depth_read_stalls (
    .clk_i, .count_i(depth_rd_valid_o && !depth_rd_ready_i), .kind_i(1'b0)
  );
  cycle_counters #(.Kinds(1)) u_depth_write_stalls (
    .clk_i, .count_i(depth_wr_valid_o && !depth_wr_ready_i), .kind_i(1'b0)
  );
`else
  assign cause = !next_valid ? cycle_cause_pkg::STARVED :
                 next_ready ? cycle_cause_pkg::BUSY : cycle_cause_pkg::BLOCKED;
`endif
  cycle_counters #(.Kinds(1)) u_color_write_stalls (
    .clk_i, .count_i(color_wr_valid_o && !color_wr_ready_i), .kind_i(1'b0)
  );
  cycle_counters #(.Kinds(cycle_cause_pkg::CAUSES)) u_cycles (
    .clk_i, .count_i(1'b1), .kind_i(cause)
  );
  // The cycles that begin at each level of the FIFO
  cycle_counters #(.Kinds(pineda_pkg::STAMP_FIFO_DEPTH + 1)) u_levels (
    .clk_i, .count_i(1'b1), .kind_i(u_stamps.count_q)
  );
  // Stamps tested, by covered samples that passed and by those that failed
  localparam int unsigned SAMPLES_BITS = $clog2(LANES + 1);
  cycle_counters #(.Kinds(LANES + 1)) u_passed (
    .clk_i, .count_i(load), .kind_i(SAMPLES_BITS'($countones(passed)))
  );
  cycle_counters #(.Kinds(LANES + 1)) u_failed (
    .clk_i, .count_i(load), .kind_i(SAMPLES_BITS'($countones(head.mask & ~passed)))
  );
`endif

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
`ifdef PINEDA_DEPTH
      assert (!accept || places_q != COUNT_BITS'(INFLIGHT)) else $error("too many stamps wait");
      assert (!depth_rsp_valid_i || !table_empty) else $error("a response nobody asked for");
`endif
`ifdef PINEDA_ATTRIBUTES
      assert (!attr_valid || attr_ready) else $error("attributes find their FIFO full");
`endif
      assert (!stamp_valid_i || stamp_i.mask != '0) else $error("an empty stamp");
    end
  end
`endif
endmodule
