// Hierarchical z: the greatest depth stored in each tile of the frame, the top bits.
//
// Bits     timing::HierarchicalZ defines them: of every stamp of a tile the greatest depth after
//          its last write, and of these the greatest. A stamp not written yet has the cleared
//          depth, one outside the frame 0. Tiles beyond HIERARCHICAL_Z_TILES: all ones, which hides
//          nothing.
// In       clear_i: a frame begins; clear_depth_i and frame_*_i: stable from then on. update_i: a
//          stamp whose depth write is accepted in this cycle.
// Out      z_max_o: of the tile asked for, in the same cycle, with the updates of
//          HIERARCHICAL_Z_DELAY_CYCLES ago and before.
// Rate     a look-up and an update a cycle.
// Drops    updates of tiles beyond HIERARCHICAL_Z_TILES.
// Twin     model/timing/units/hierarchical_z.cpp.
`ifdef PINEDA_HIERARCHICAL_Z
module hierarchical_z #(
  parameter int unsigned FlagsLog2 = 12  // the flags of so many tiles are one register
) (
  input  logic                                          clk_i,
  input  logic                                          rst_ni,
  input  logic                                          clear_i,
  input  logic [pineda_pkg::HIERARCHICAL_Z_BITS-1:0]    clear_depth_i,
  input  logic [pineda_pkg::FRAME_SIZE_BITS-1:0]        frame_width_i,
  input  logic [pineda_pkg::FRAME_SIZE_BITS-1:0]        frame_height_i,

  input  logic [pineda_pkg::TILE_INDEX_BITS-1:0]        tile_x_i,
  input  logic [pineda_pkg::TILE_INDEX_BITS-1:0]        tile_y_i,
  output logic [pineda_pkg::HIERARCHICAL_Z_BITS-1:0]    z_max_o,

  input  logic                                          update_valid_i,
  input  pineda_pkg::depth_max_t                        update_i
);
  localparam int unsigned BITS = pineda_pkg::HIERARCHICAL_Z_BITS;
  localparam int unsigned DELAY = pineda_pkg::HIERARCHICAL_Z_DELAY_CYCLES;
  localparam int unsigned TILE_LOG2 = pineda_pkg::TILE_LOG2;
  localparam int unsigned TILE_BITS = pineda_pkg::TILE_INDEX_BITS;
  // No more than the largest frame has
  localparam int unsigned FRAME_TILES = 1 << (2 * TILE_BITS);
  localparam int unsigned TILES = pineda_pkg::HIERARCHICAL_Z_TILES < FRAME_TILES ?
                                  pineda_pkg::HIERARCHICAL_Z_TILES : FRAME_TILES;
  // Stamp column and row inside a tile
  localparam int unsigned X_BITS = TILE_LOG2 - pineda_pkg::STAMP_WIDTH_LOG2;
  localparam int unsigned Y_BITS = TILE_LOG2 - pineda_pkg::STAMP_HEIGHT_LOG2;
  localparam int unsigned STAMPS = 1 << (X_BITS + Y_BITS);
  localparam int unsigned WORD_BITS = STAMPS * BITS;
  localparam int unsigned INDEX_BITS = 2 * TILE_BITS + 1;
  localparam int unsigned ADDRESS_BITS = TILES > 1 ? $clog2(TILES) : 1;
  localparam int unsigned FLAGS_LOG2 = ADDRESS_BITS < FlagsLog2 ? ADDRESS_BITS : FlagsLog2;
  localparam int unsigned FLAG_WORDS = ((TILES - 1) >> FLAGS_LOG2) + 1;
  localparam int unsigned WORD_INDEX_BITS = FLAG_WORDS > 1 ? $clog2(FLAG_WORDS) : 1;

  // ---- Where a tile lies: row by row
  logic [TILE_BITS:0] columns;
  assign columns = (TILE_BITS+1)'((frame_width_i - pineda_pkg::FRAME_SIZE_BITS'(1)) >> TILE_LOG2) +
                   (TILE_BITS+1)'(1);
  function automatic logic [INDEX_BITS-1:0] tile_index(input logic [TILE_BITS-1:0] x,
                                                       input logic [TILE_BITS-1:0] y,
                                                       input logic [TILE_BITS:0] of_row);
    tile_index = INDEX_BITS'(y) * INDEX_BITS'(of_row) + INDEX_BITS'(x);
  endfunction

  // ---- The updates on their way
  logic due_valid;
  pineda_pkg::depth_max_t due;
  if (DELAY == 1) begin : gen_no_delay
    assign due_valid = update_valid_i;
    assign due = update_i;
  end else begin : gen_delay
    logic [DELAY-2:0] valid_q;
    logic [$bits(due)-1:0] delayed_q [DELAY-1]; // not of structs: Yosys 0.23 drops such a memory
    assign due_valid = valid_q[DELAY-2];
    assign due = delayed_q[DELAY-2];
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        valid_q <= '0;
      end else if (clear_i) begin
        valid_q <= '0;
      end else begin
        valid_q[0] <= update_valid_i;
        for (int unsigned i = 1; i < DELAY - 1; i++) valid_q[i] <= valid_q[i-1];
      end
    end
    always_ff @(posedge clk_i) begin
      delayed_q[0] <= update_i;
      for (int unsigned i = 1; i < DELAY - 1; i++) delayed_q[i] <= delayed_q[i-1];
    end
  end

  // ---- The depths of a tile's stamps; a tile that has none yet is as cleared
  logic [(1<<FLAGS_LOG2)-1:0] written_q [FLAG_WORDS];
  logic [WORD_BITS-1:0] depth_q [TILES];

  logic [INDEX_BITS-1:0] due_index, asked_index;
  logic [ADDRESS_BITS-1:0] due_address, asked_address;
  logic due_kept, asked_kept;
  assign due_index = tile_index(due.x[X_BITS +: TILE_BITS], due.y[Y_BITS +: TILE_BITS], columns);
  assign asked_index = tile_index(tile_x_i, tile_y_i, columns);
  assign due_kept = due_index < INDEX_BITS'(TILES);
  assign asked_kept = asked_index < INDEX_BITS'(TILES);
  assign due_address = due_kept ? due_index[ADDRESS_BITS-1:0] : '0;
  assign asked_address = asked_kept ? asked_index[ADDRESS_BITS-1:0] : '0;

  // The stamps of the tile that lie inside the frame have the cleared depth.
  logic [WORD_BITS-1:0] cleared, stored, changed;
  logic [pineda_pkg::STAMP_X_BITS-1:0] last_x;
  logic [pineda_pkg::STAMP_Y_BITS-1:0] last_y;
  assign last_x = pineda_pkg::STAMP_X_BITS'(
      (frame_width_i - pineda_pkg::FRAME_SIZE_BITS'(1)) >> pineda_pkg::STAMP_WIDTH_LOG2);
  assign last_y = pineda_pkg::STAMP_Y_BITS'(
      (frame_height_i - pineda_pkg::FRAME_SIZE_BITS'(1)) >> pineda_pkg::STAMP_HEIGHT_LOG2);
  always_comb begin
    cleared = '0;
    if (due_valid) begin
      for (int unsigned i = 0; i < STAMPS; i++) begin
        if ({due.x[X_BITS +: TILE_BITS], X_BITS'(i % (1 << X_BITS))} <= last_x &&
            {due.y[Y_BITS +: TILE_BITS], Y_BITS'(i >> X_BITS)} <= last_y) begin
          cleared[i*BITS +: BITS] = clear_depth_i;
        end
      end
    end
  end
  function automatic logic [WORD_INDEX_BITS-1:0] flag_word(
      input logic [ADDRESS_BITS-1:0] address);
    flag_word = WORD_INDEX_BITS'(address >> FLAGS_LOG2);
  endfunction
  logic due_written, asked_written;
  assign due_written = written_q[flag_word(due_address)][due_address[FLAGS_LOG2-1:0]];
  assign asked_written = written_q[flag_word(asked_address)][asked_address[FLAGS_LOG2-1:0]];
  assign stored = due_written ? depth_q[due_address] : cleared;
  always_comb begin
    changed = 'x;
    if (due_valid) begin
      changed = stored;
      for (int unsigned i = 0; i < STAMPS; i++) begin
        if (due.x[X_BITS-1:0] == X_BITS'(i % (1 << X_BITS)) &&
            due.y[Y_BITS-1:0] == Y_BITS'(i >> X_BITS)) begin
          changed[i*BITS +: BITS] = due.z;
        end
      end
    end
  end

  for (genvar word = 0; word < FLAG_WORDS; word++) begin : gen_flags
    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) written_q[word] <= '0;
      else if (clear_i) written_q[word] <= '0;
      else if (due_valid && due_kept && flag_word(due_address) == WORD_INDEX_BITS'(word)) begin
        written_q[word][due_address[FLAGS_LOG2-1:0]] <= 1'b1;
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (due_valid && due_kept) depth_q[due_address] <= changed;
  end

  // ---- The greatest of the tile asked for
  logic [WORD_BITS-1:0] asked;
  assign asked = depth_q[asked_address];
  always_comb begin
    z_max_o = asked_kept ? clear_depth_i : '1;
    if (asked_kept && asked_written) begin
      z_max_o = '0;
      for (int unsigned i = 0; i < STAMPS; i++) begin
        if (asked[i*BITS +: BITS] > z_max_o) z_max_o = asked[i*BITS +: BITS];
      end
    end
  end
endmodule
`endif
