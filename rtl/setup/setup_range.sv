// Pixels of one axis whose centres lie in [low, high), clipped by the scissor. No state.
//
// Bits     core::setup() defines the box of samples.
// Out      first_o to last_o, inclusive; of no meaning where empty_o.
// Twin     model/core/setup.cpp.
module setup_range (
  input  logic signed [pineda_pkg::COORD_BITS-1:0]   low_i,
  input  logic signed [pineda_pkg::COORD_BITS-1:0]   high_i,
  input  logic [pineda_pkg::FRAME_SIZE_BITS-1:0]     clip_first_i, // [first, end)
  input  logic [pineda_pkg::FRAME_SIZE_BITS-1:0]     clip_end_i,

  output logic                                       empty_o,
  output logic [pineda_pkg::PIXEL_BITS-1:0]          first_o,
  output logic [pineda_pkg::PIXEL_BITS-1:0]          last_o
);
  localparam int unsigned S = pineda_pkg::SUBPIXEL_BITS;
  localparam int unsigned COORD_BITS = pineda_pkg::COORD_BITS;
  localparam int unsigned PIXEL_BITS = pineda_pkg::PIXEL_BITS;
  // Pixel indices of vertices anywhere in the guard band, and the frame's size beside them
  localparam int unsigned RANGE_BITS = COORD_BITS - S + 1;

  // first = ceil(low - 1/2), last = ceil(high - 1/2) - 1
  logic signed [COORD_BITS:0] low_moved, high_moved;
  assign low_moved = (COORD_BITS+1)'(low_i) + (COORD_BITS+1)'((1 << (S - 1)) - 1);
  assign high_moved = (COORD_BITS+1)'(high_i) - (COORD_BITS+1)'((1 << (S - 1)) + 1);
  logic signed [RANGE_BITS-1:0] first, last, clip_first, clip_last;
  assign first = low_moved[COORD_BITS:S];
  assign last = high_moved[COORD_BITS:S];
  assign clip_first = RANGE_BITS'(clip_first_i);
  assign clip_last = RANGE_BITS'(clip_end_i) - RANGE_BITS'(1);

  logic signed [RANGE_BITS-1:0] clipped_first, clipped_last;
  assign clipped_first = first < clip_first ? clip_first : first;
  assign clipped_last = last > clip_last ? clip_last : last;
  logic no_sample;
  assign no_sample = first > last;
  assign empty_o = no_sample || clipped_first > clipped_last;
  assign first_o = clipped_first[PIXEL_BITS-1:0];
  assign last_o = clipped_last[PIXEL_BITS-1:0];
endmodule
