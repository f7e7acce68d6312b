// Generated from model/spec for the design high_tile. Do not edit: change model/spec and run
// `cmake --build build --target package`.
`define PINEDA_SETUP_STEPPED
`define PINEDA_RECIPROCAL_NEWTON
`define PINEDA_DEPTH
`define PINEDA_PLANES
`define PINEDA_ATTRIBUTES
`define PINEDA_AFFINE
package pineda_pkg;

  localparam int unsigned SUBPIXEL_BITS             = 8; // S: x, y are multiples of 2^-S px
  localparam int unsigned COORD_BITS                = 23; // x, y
  localparam int unsigned EDGE_COEFF_BITS           = 24; // a, b
  localparam int unsigned AREA2_BITS                = 47; // doubled area, E
  localparam int unsigned EDGE_BITS                 = 39; // E' = (E - bias) >> S
  localparam int unsigned TILE_EDGE_BITS            = 28; // E' of an edge that cuts the tile
  localparam int unsigned AREA2_LENGTH_BITS         = 6; // bit length of the doubled area
  localparam int unsigned DEPTH_BITS                = 24; // a depth code
  localparam int unsigned DEPTH_INPUT_FRACTION_BITS = 8; // fraction of a vertex's z
  localparam int unsigned DEPTH_IN_BITS             = 32; // a vertex's z
  localparam int unsigned DEPTH_NUMERATOR_BITS      = 56; // gradient numerator of z
  localparam int unsigned DEPTH_PLANE_BITS          = 44; // gradient, reference, accumulator of z
  localparam int unsigned DEPTH_TILE_PLANE_BITS     = 34; // the same inside a tile
  localparam int unsigned BIAS_FACTOR_FRACTION_BITS = 8; // gradient's magnitude, slope factor
  localparam int unsigned BIAS_MAGNITUDE_BITS       = 35; // the magnitude, saturated
  localparam int unsigned BIAS_SLOPE_BITS           = 16; // the slope factor
  localparam int unsigned BIAS_CONSTANT_BITS        = 25; // the constant
  localparam int unsigned BIAS_FRACTION_BITS        = 16; // fraction of the bias
  localparam int unsigned DEPTH_BIAS_BITS           = 42; // the bias, saturated
  localparam int unsigned INFLIGHT_STAMPS           = 20; // stamps between read issued and write accepted
  localparam int unsigned ATTRIBUTES                = 4; // interpolated attributes
  localparam int unsigned ATTR_BITS                 = 8; // one attribute
  localparam int unsigned ATTRIBUTE_CYCLES          = 1; // from the depth test to the colours
  localparam int unsigned ATTR_NUMERATOR_BITS       = 32; // gradient numerator of an attribute
  localparam int unsigned ATTR_PLANE_BITS           = 28; // gradient, reference, accumulator of an attribute
  localparam int unsigned ATTR_TILE_PLANE_BITS      = 18; // the same inside a tile
  localparam int unsigned GRADIENT_FRACTION_BITS    = 18; // F
  localparam int unsigned TILE_FRACTION_BITS        = 8; // F': inside a tile
  localparam int unsigned PLANES                    = 5; // depth, then affine attributes
  localparam int unsigned VALUE_BITS                = 32; // what a plane is made of: the widest
  localparam int unsigned VALUE_FRACTION_BITS       = 8; // its fraction
  localparam int unsigned NUMERATOR_BITS            = 56; // its gradient numerator
  localparam int unsigned PLANE_BITS                = 44; // gradient, reference: the widest
  localparam int unsigned SETUP_PLANES_STEP         = 12; // step of setup in which the first starts
  localparam int unsigned TILE_LOG2                 = 3; // tile side, log2 px
  localparam int unsigned STAMP_WIDTH_LOG2          = 1; // log2 px
  localparam int unsigned STAMP_HEIGHT_LOG2         = 1; // log2 px
  localparam int unsigned LANES                     = 4; // samples of a stamp
  localparam int unsigned TESTED_STAMPS_LOG2        = 2; // stamps whose coverage is found in a cycle
  localparam int unsigned FRAME_SIZE_BITS           = 15; // width, height of a frame
  localparam int unsigned PIXEL_BITS                = 14; // pixel column or row
  localparam int unsigned TILE_INDEX_BITS           = 11; // tile column or row
  localparam int unsigned STAMP_X_BITS              = 13; // stamp column
  localparam int unsigned STAMP_Y_BITS              = 13; // stamp row
  localparam int unsigned STAMP_COLUMN_BITS         = 2; // the same inside a tile; 1 where it is always 0
  localparam int unsigned STAMP_ROW_BITS            = 2;
  localparam int unsigned SETUP_INTERVAL_CYCLES     = 6; // a triangle every so many cycles
  localparam int unsigned SETUP_LATENCY_CYCLES      = 27; // from a triangle to its primitive
  localparam int unsigned MULTIPLIER_STAGES         = 1; // of a product where one starts every cycle
  localparam int unsigned PRIM_FIFO_DEPTH           = 0; // setup -> traversal
  localparam int unsigned TILE_FIFO_DEPTH           = 1; // tile test -> coverage
  localparam int unsigned STAMP_FIFO_DEPTH          = 4; // traversal -> interpolation
  localparam int unsigned PLANE_SLOTS               = 6; // tiles whose planes are kept for stamps in flight
  localparam int unsigned RECIPROCAL_BITS           = 30; // k: mantissa of a reciprocal
  localparam int unsigned RECIPROCAL_CYCLES         = 6; // from the doubled area to it
  localparam int unsigned PIPELINED_RECIPROCAL_CYCLES= 6; // the same where one starts every cycle
  localparam int unsigned RECIPROCAL_LUT_BITS       = 7; // index of the ROM
  localparam int unsigned RECIPROCAL_ROM_BITS       = 8; // entry of the ROM, leading 1 implied
  localparam int unsigned RECIPROCAL_NEWTON_STEPS   = 2;

  // The triangle number only travels in simulation.
`ifdef SYNTHESIS
  localparam int unsigned ID_BITS = 1;
`else
  localparam int unsigned ID_BITS = 32;
`endif

  localparam logic [1:0] CULL_NONE      = 2'd0;
  localparam logic [1:0] CULL_BACK      = 2'd1;
  localparam logic [1:0] CULL_FRONT     = 2'd2;
  localparam logic [0:0] SHADE_SMOOTH   = 1'd0;
  localparam logic [0:0] SHADE_FLAT     = 1'd1;
  localparam logic [3:0] DEPTH_LESS     = 4'd0;
  localparam logic [3:0] DEPTH_LEQUAL   = 4'd1;
  localparam logic [3:0] DEPTH_OFF      = 4'd2;
  localparam logic [3:0] DEPTH_NEVER    = 4'd3;
  localparam logic [3:0] DEPTH_EQUAL    = 4'd4;
  localparam logic [3:0] DEPTH_GREATER  = 4'd5;
  localparam logic [3:0] DEPTH_NOTEQUAL = 4'd6;
  localparam logic [3:0] DEPTH_GEQUAL   = 4'd7;
  localparam logic [3:0] DEPTH_ALWAYS   = 4'd8;

  typedef struct packed {
    logic        [14:0]          width; // u15 px
    logic        [14:0]          height; // u15 px
    logic        [1:0]           cull; // u2 none/back/front
    logic        [3:0]           depth; // u4 function
    logic        [0:0]           depth_write; // u1 off/on
    logic        [0:0]           shade; // u1 smooth/flat
    logic        [14:0]          clip_x0; // u15 px
    logic        [14:0]          clip_y0; // u15 px
    logic        [14:0]          clip_x1; // u15 px
    logic        [14:0]          clip_y1; // u15 px
    logic signed [24:0]          bias_constant; // s25 code
    logic signed [15:0]          bias_slope; // sQ7.8 px
    logic        [23:0]          clear_depth; // u24 code
  } frame_t;
  localparam int unsigned FRAME_BITS = 163;

  typedef struct packed {
    logic        [ID_BITS-1:0]   id; // number of the triangle
    logic        [68:0]          x; // sQ14.8 px, 3 of them, the first lowest
    logic        [68:0]          y; // sQ14.8 px, 3 of them, the first lowest
    logic        [95:0]          z; // uQ24.8 code, 3 of them, the first lowest
    logic        [95:0]          attr; // u8 LSB, 12 of them, the first lowest
  } triangle_t;
  localparam int unsigned TRIANGLE_BITS = ID_BITS + 330;

  typedef struct packed {
    logic        [ID_BITS-1:0]   id; // number of the triangle
    logic        [13:0]          x0; // u14 px
    logic        [13:0]          y0; // u14 px
    logic        [13:0]          x1; // u14 px
    logic        [13:0]          y1; // u14 px
    logic        [71:0]          a; // sQ15.8 px, 3 of them, the first lowest
    logic        [71:0]          b; // sQ15.8 px, 3 of them, the first lowest
    logic        [116:0]         e; // sQ30.8 px^2, 3 of them, the first lowest
    logic signed [43:0]          z_dx; // sQ25.18 code/px
    logic signed [43:0]          z_dy; // sQ25.18 code/px
    logic signed [43:0]          z_ref; // sQ25.18 code
    logic signed [41:0]          z_bias; // sQ25.16 code
    logic        [111:0]         attr_dx; // sQ9.18 LSB/px, 4 of them, the first lowest
    logic        [111:0]         attr_dy; // sQ9.18 LSB/px, 4 of them, the first lowest
    logic        [111:0]         attr_ref; // sQ9.18 LSB, 4 of them, the first lowest
  } setup_prim_t;
  localparam int unsigned SETUP_PRIM_BITS = ID_BITS + 827;

  typedef struct packed {
    logic        [ID_BITS-1:0]   id; // number of the triangle
    logic        [10:0]          x; // u11 tile
    logic        [10:0]          y; // u11 tile
    logic        [2:0]           x0; // u3 px
    logic        [2:0]           y0; // u3 px
    logic        [2:0]           x1; // u3 px
    logic        [2:0]           y1; // u3 px
    logic        [71:0]          a; // sQ15.8 px, 3 of them, the first lowest
    logic        [71:0]          b; // sQ15.8 px, 3 of them, the first lowest
    logic        [83:0]          e; // sQ19.8 px^2, 3 of them, the first lowest
    logic        [2:0]           accepted; // u3 edge
    logic signed [33:0]          z_dx; // sQ25.8 code/px
    logic signed [33:0]          z_dy; // sQ25.8 code/px
    logic signed [33:0]          z_ref; // sQ25.8 code
    logic signed [41:0]          z_bias; // sQ25.16 code
    logic        [71:0]          attr_dx; // sQ9.8 LSB/px, 4 of them, the first lowest
    logic        [71:0]          attr_dy; // sQ9.8 LSB/px, 4 of them, the first lowest
    logic        [71:0]          attr_ref; // sQ9.8 LSB, 4 of them, the first lowest
  } tile_t;
  localparam int unsigned TILE_BITS = ID_BITS + 625;

  typedef struct packed {
    logic        [ID_BITS-1:0]   id; // number of the triangle
    logic        [12:0]          x; // u13 stamp
    logic        [12:0]          y; // u13 stamp
    logic        [3:0]           mask; // u4 lane
    logic        [0:0]           first; // u1
    logic signed [33:0]          z_dx; // sQ25.8 code/px
    logic signed [33:0]          z_dy; // sQ25.8 code/px
    logic signed [33:0]          z_ref; // sQ25.8 code
    logic signed [41:0]          z_bias; // sQ25.16 code
    logic        [71:0]          attr_dx; // sQ9.8 LSB/px, 4 of them, the first lowest
    logic        [71:0]          attr_dy; // sQ9.8 LSB/px, 4 of them, the first lowest
    logic        [71:0]          attr_ref; // sQ9.8 LSB, 4 of them, the first lowest
  } stamp_t;
  localparam int unsigned STAMP_BITS = ID_BITS + 391;

  typedef struct packed {
    logic        [ID_BITS-1:0]   id; // number of the triangle
    logic        [12:0]          x; // u13 stamp
    logic        [12:0]          y; // u13 stamp
    logic        [3:0]           mask; // u4 lane
  } depth_read_t;
  localparam int unsigned DEPTH_READ_BITS = ID_BITS + 30;

  typedef struct packed {
    logic        [95:0]          z; // u24 code, 4 of them, the first lowest
  } depth_data_t;
  localparam int unsigned DEPTH_DATA_BITS = 96;

  typedef struct packed {
    logic        [ID_BITS-1:0]   id; // number of the triangle
    logic        [12:0]          x; // u13 stamp
    logic        [12:0]          y; // u13 stamp
    logic        [3:0]           mask; // u4 lane
    logic        [95:0]          z; // u24 code, 4 of them, the first lowest
  } depth_write_t;
  localparam int unsigned DEPTH_WRITE_BITS = ID_BITS + 126;

  typedef struct packed {
    logic        [ID_BITS-1:0]   id; // number of the triangle
    logic        [12:0]          x; // u13 stamp
    logic        [12:0]          y; // u13 stamp
    logic        [3:0]           mask; // u4 lane
    logic        [127:0]         attr; // u8 LSB, 16 of them, the first lowest
  } color_write_t;
  localparam int unsigned COLOR_WRITE_BITS = ID_BITS + 158;

  // First guess of 1/(2m), m = 0.1<index>...: value (2^8 + entry) / 2^9.
  function automatic logic [RECIPROCAL_ROM_BITS-1:0] reciprocal_rom(
      input logic [RECIPROCAL_LUT_BITS-1:0] index);
    case (index)
      7'd0: reciprocal_rom = 8'd254;
      7'd1: reciprocal_rom = 8'd250;
      7'd2: reciprocal_rom = 8'd246;
      7'd3: reciprocal_rom = 8'd242;
      7'd4: reciprocal_rom = 8'd239;
      7'd5: reciprocal_rom = 8'd235;
      7'd6: reciprocal_rom = 8'd231;
      7'd7: reciprocal_rom = 8'd228;
      7'd8: reciprocal_rom = 8'd224;
      7'd9: reciprocal_rom = 8'd221;
      7'd10: reciprocal_rom = 8'd217;
      7'd11: reciprocal_rom = 8'd214;
      7'd12: reciprocal_rom = 8'd210;
      7'd13: reciprocal_rom = 8'd207;
      7'd14: reciprocal_rom = 8'd204;
      7'd15: reciprocal_rom = 8'd201;
      7'd16: reciprocal_rom = 8'd198;
      7'd17: reciprocal_rom = 8'd194;
      7'd18: reciprocal_rom = 8'd191;
      7'd19: reciprocal_rom = 8'd188;
      7'd20: reciprocal_rom = 8'd185;
      7'd21: reciprocal_rom = 8'd182;
      7'd22: reciprocal_rom = 8'd179;
      7'd23: reciprocal_rom = 8'd177;
      7'd24: reciprocal_rom = 8'd174;
      7'd25: reciprocal_rom = 8'd171;
      7'd26: reciprocal_rom = 8'd168;
      7'd27: reciprocal_rom = 8'd165;
      7'd28: reciprocal_rom = 8'd163;
      7'd29: reciprocal_rom = 8'd160;
      7'd30: reciprocal_rom = 8'd157;
      7'd31: reciprocal_rom = 8'd155;
      7'd32: reciprocal_rom = 8'd152;
      7'd33: reciprocal_rom = 8'd150;
      7'd34: reciprocal_rom = 8'd147;
      7'd35: reciprocal_rom = 8'd145;
      7'd36: reciprocal_rom = 8'd142;
      7'd37: reciprocal_rom = 8'd140;
      7'd38: reciprocal_rom = 8'd138;
      7'd39: reciprocal_rom = 8'd135;
      7'd40: reciprocal_rom = 8'd133;
      7'd41: reciprocal_rom = 8'd131;
      7'd42: reciprocal_rom = 8'd128;
      7'd43: reciprocal_rom = 8'd126;
      7'd44: reciprocal_rom = 8'd124;
      7'd45: reciprocal_rom = 8'd122;
      7'd46: reciprocal_rom = 8'd120;
      7'd47: reciprocal_rom = 8'd117;
      7'd48: reciprocal_rom = 8'd115;
      7'd49: reciprocal_rom = 8'd113;
      7'd50: reciprocal_rom = 8'd111;
      7'd51: reciprocal_rom = 8'd109;
      7'd52: reciprocal_rom = 8'd107;
      7'd53: reciprocal_rom = 8'd105;
      7'd54: reciprocal_rom = 8'd103;
      7'd55: reciprocal_rom = 8'd101;
      7'd56: reciprocal_rom = 8'd99;
      7'd57: reciprocal_rom = 8'd97;
      7'd58: reciprocal_rom = 8'd95;
      7'd59: reciprocal_rom = 8'd94;
      7'd60: reciprocal_rom = 8'd92;
      7'd61: reciprocal_rom = 8'd90;
      7'd62: reciprocal_rom = 8'd88;
      7'd63: reciprocal_rom = 8'd86;
      7'd64: reciprocal_rom = 8'd84;
      7'd65: reciprocal_rom = 8'd83;
      7'd66: reciprocal_rom = 8'd81;
      7'd67: reciprocal_rom = 8'd79;
      7'd68: reciprocal_rom = 8'd78;
      7'd69: reciprocal_rom = 8'd76;
      7'd70: reciprocal_rom = 8'd74;
      7'd71: reciprocal_rom = 8'd73;
      7'd72: reciprocal_rom = 8'd71;
      7'd73: reciprocal_rom = 8'd69;
      7'd74: reciprocal_rom = 8'd68;
      7'd75: reciprocal_rom = 8'd66;
      7'd76: reciprocal_rom = 8'd64;
      7'd77: reciprocal_rom = 8'd63;
      7'd78: reciprocal_rom = 8'd61;
      7'd79: reciprocal_rom = 8'd60;
      7'd80: reciprocal_rom = 8'd58;
      7'd81: reciprocal_rom = 8'd57;
      7'd82: reciprocal_rom = 8'd55;
      7'd83: reciprocal_rom = 8'd54;
      7'd84: reciprocal_rom = 8'd52;
      7'd85: reciprocal_rom = 8'd51;
      7'd86: reciprocal_rom = 8'd50;
      7'd87: reciprocal_rom = 8'd48;
      7'd88: reciprocal_rom = 8'd47;
      7'd89: reciprocal_rom = 8'd45;
      7'd90: reciprocal_rom = 8'd44;
      7'd91: reciprocal_rom = 8'd43;
      7'd92: reciprocal_rom = 8'd41;
      7'd93: reciprocal_rom = 8'd40;
      7'd94: reciprocal_rom = 8'd39;
      7'd95: reciprocal_rom = 8'd37;
      7'd96: reciprocal_rom = 8'd36;
      7'd97: reciprocal_rom = 8'd35;
      7'd98: reciprocal_rom = 8'd33;
      7'd99: reciprocal_rom = 8'd32;
      7'd100: reciprocal_rom = 8'd31;
      7'd101: reciprocal_rom = 8'd30;
      7'd102: reciprocal_rom = 8'd28;
      7'd103: reciprocal_rom = 8'd27;
      7'd104: reciprocal_rom = 8'd26;
      7'd105: reciprocal_rom = 8'd25;
      7'd106: reciprocal_rom = 8'd23;
      7'd107: reciprocal_rom = 8'd22;
      7'd108: reciprocal_rom = 8'd21;
      7'd109: reciprocal_rom = 8'd20;
      7'd110: reciprocal_rom = 8'd19;
      7'd111: reciprocal_rom = 8'd18;
      7'd112: reciprocal_rom = 8'd16;
      7'd113: reciprocal_rom = 8'd15;
      7'd114: reciprocal_rom = 8'd14;
      7'd115: reciprocal_rom = 8'd13;
      7'd116: reciprocal_rom = 8'd12;
      7'd117: reciprocal_rom = 8'd11;
      7'd118: reciprocal_rom = 8'd10;
      7'd119: reciprocal_rom = 8'd9;
      7'd120: reciprocal_rom = 8'd8;
      7'd121: reciprocal_rom = 8'd7;
      7'd122: reciprocal_rom = 8'd6;
      7'd123: reciprocal_rom = 8'd5;
      7'd124: reciprocal_rom = 8'd4;
      7'd125: reciprocal_rom = 8'd3;
      7'd126: reciprocal_rom = 8'd2;
      default: reciprocal_rom = 8'd1;
    endcase
  endfunction

endpackage
