// A rasterizer that shares nothing with the project's RTL: it looks at every pixel of a triangle's box,
// one a clock, and divides. For pineda judge, and with a bug at a time to show what that finds.
//
// Coordinates are sQ23.8 px, y down; depths uQ24.8 codes; a colour is 4 times 8 bits, red lowest. Affine.
module box_scan (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic [3:0]               bug_i, // 0: none; see the bench

  // The frame and its state, held while it is drawn
  input  logic [15:0]              width_i,
  input  logic [15:0]              height_i,
  input  logic [1:0]               cull_i,  // 0 none, 1 back, 2 front
  input  logic [2:0]               pass_i,  // passes where the depth is less, equal, greater
  input  logic                     write_i, // of depths that pass
  input  logic signed [3:0][31:0]  scissor_i, // first x, first y, end x, end y

  // Memory is written from outside before the frame, a sample a clock.
  input  logic                     clear_i,
  input  logic [15:0]              clear_address_i,
  input  logic [23:0]              clear_depth_i,

  input  logic                     tri_valid_i,
  output logic                     tri_ready_o,
  input  logic signed [2:0][31:0]  x_i,
  input  logic signed [2:0][31:0]  y_i,
  input  logic [2:0][31:0]         z_i,
  input  logic [2:0][31:0]         rgba_i,

  // A sample that is covered
  output logic                     hit_o,
  output logic                     drawn_o, // and passes the depth test
  output logic [15:0]              address_o,
  output logic [23:0]              depth_o, // what is stored then
  output logic [31:0]              rgba_o
);
  localparam logic [3:0] INCLUSIVE = 1;   // samples on any edge belong to the triangle
  localparam logic [3:0] SHORT_BOX = 2;   // the box lacks its last column
  localparam logic [3:0] CULLS_OTHER = 3; // the other faces are culled
  localparam logic [3:0] NO_BOTTOM = 4;   // the scissor has no lower border
  localparam logic [3:0] TIE_PASSES = 5;  // equal depths pass as well
  localparam logic [3:0] ALWAYS = 6;      // no depth test
  localparam logic [3:0] SHORT_DEPTH = 7; // depths lack their low four bits
  localparam logic [3:0] SWAPPED = 8;     // red and blue

  logic busy_q;
  logic signed [63:0] x_q [3];
  logic signed [63:0] y_q [3];
  logic [2:0][31:0] z_q, rgba_q;
  logic signed [31:0] first_x_q, last_x_q, last_y_q, px_q, py_q; // px
  logic [23:0] depth_mem [65536];

  // ---- Edge functions at the sample, and the doubled area: their sum
  logic signed [63:0] e [3];
  logic signed [63:0] area, sample_x, sample_y;
  assign sample_x = (64'(px_q) <<< 8) + 64'sd128;
  assign sample_y = (64'(py_q) <<< 8) + 64'sd128;
  logic covered;
  always_comb begin
    covered = 1'b1;
    area = 64'd0;
    for (int i = 0; i < 3; i++) begin
      automatic logic [1:0] from = 2'((i + 1) % 3);
      automatic logic [1:0] to = 2'((i + 2) % 3);
      e[i] = (x_q[to] - x_q[from]) * (sample_y - y_q[from]) -
             (y_q[to] - y_q[from]) * (sample_x - x_q[from]);
      area = area + e[i];
    end
    for (int i = 0; i < 3; i++) begin
      // Clockwise on screen, y down, the inside lies to the right of each edge.
      automatic logic [1:0] from = 2'(area > 0 ? (i + 1) % 3 : (i + 2) % 3);
      automatic logic [1:0] to = 2'(area > 0 ? (i + 2) % 3 : (i + 1) % 3);
      automatic logic is_left = y_q[to] < y_q[from];
      automatic logic is_top = y_q[to] == y_q[from] && x_q[to] > x_q[from];
      if (e[i] == 0) covered = covered && (is_left || is_top || bug_i == INCLUSIVE);
      else covered = covered && (e[i] > 0) == (area > 0);
    end
  end

  logic culled, in_scissor;
  assign culled = area == 0 ||
      ((cull_i == 1) != (bug_i == CULLS_OTHER) && cull_i != 0 && area > 0) ||
      ((cull_i == 2) != (bug_i == CULLS_OTHER) && cull_i != 0 && area < 0);
  assign in_scissor = px_q >= signed'(scissor_i[0]) && py_q >= signed'(scissor_i[1]) &&
      px_q < signed'(scissor_i[2]) && (py_q < signed'(scissor_i[3]) || bug_i == NO_BOTTOM);

  // ---- Values, to the nearest
  function automatic logic [31:0] nearest(input logic signed [127:0] sum, input logic signed [127:0] unit);
    nearest = 32'((2 * sum + unit) / (2 * unit));
  endfunction
  logic signed [127:0] z_sum, color_sum [4];
  logic [23:0] depth, stored;
  logic passes;
  always_comb begin
    z_sum = '0;
    for (int k = 0; k < 4; k++) color_sum[k] = '0;
    for (int i = 0; i < 3; i++) begin
      z_sum = z_sum + 128'(e[i]) * signed'(128'(z_q[i]));
      for (int k = 0; k < 4; k++) color_sum[k] = color_sum[k] + 128'(e[i]) * signed'(128'(rgba_q[i][8*k +: 8]));
    end
    depth = '0;
    rgba_o = '0;
    if (hit_o) begin
      depth = 24'(nearest(z_sum, 128'(area) <<< 8));
      for (int k = 0; k < 4; k++) rgba_o[8*k +: 8] = 8'(nearest(color_sum[k], 128'(area)));
    end
    if (bug_i == SHORT_DEPTH) depth[3:0] = '0;
    if (bug_i == SWAPPED) {rgba_o[23:16], rgba_o[7:0]} = {rgba_o[7:0], rgba_o[23:16]};
  end
  assign stored = depth_mem[address_o];
  assign passes = bug_i == ALWAYS || (depth < stored && pass_i[0]) ||
      (depth == stored && (pass_i[1] || bug_i == TIE_PASSES)) || (depth > stored && pass_i[2]);

  assign hit_o = busy_q && covered && !culled && in_scissor;
  assign drawn_o = hit_o && passes;
  assign address_o = 16'(py_q * signed'(32'(width_i)) + px_q);
  assign depth_o = write_i && passes ? depth : stored;
  assign tri_ready_o = !busy_q;

  // ---- The box: pixels whose sample lies in it, clipped to the frame
  function automatic logic signed [31:0] least(input logic signed [2:0][31:0] v);
    least = signed'(v[0]) < signed'(v[1]) ? v[0] : v[1];
    if (signed'(v[2]) < least) least = v[2];
  endfunction
  function automatic logic signed [31:0] greatest(input logic signed [2:0][31:0] v);
    greatest = signed'(v[0]) > signed'(v[1]) ? v[0] : v[1];
    if (signed'(v[2]) > greatest) greatest = v[2];
  endfunction
  logic signed [31:0] box_x0, box_y0, box_x1, box_y1;
  always_comb begin
    box_x0 = (least(x_i) + 127) >>> 8;
    box_y0 = (least(y_i) + 127) >>> 8;
    box_x1 = (greatest(x_i) - 128) >>> 8;
    box_y1 = (greatest(y_i) - 128) >>> 8;
    if (bug_i == SHORT_BOX) box_x1 = box_x1 - 1;
    if (box_x0 < 0) box_x0 = 0;
    if (box_y0 < 0) box_y0 = 0;
    if (box_x1 >= signed'(32'(width_i))) box_x1 = signed'(32'(width_i)) - 1;
    if (box_y1 >= signed'(32'(height_i))) box_y1 = signed'(32'(height_i)) - 1;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) busy_q <= 1'b0;
    else if (tri_valid_i && tri_ready_o) busy_q <= box_x0 <= box_x1 && box_y0 <= box_y1;
    else if (px_q == last_x_q && py_q == last_y_q) busy_q <= 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (tri_valid_i && tri_ready_o) begin
      for (int i = 0; i < 3; i++) begin
        x_q[i] <= 64'(signed'(x_i[i]));
        y_q[i] <= 64'(signed'(y_i[i]));
      end
      z_q <= z_i;
      rgba_q <= rgba_i;
      first_x_q <= box_x0;
      last_x_q <= box_x1;
      last_y_q <= box_y1;
      px_q <= box_x0;
      py_q <= box_y0;
    end else begin
      px_q <= px_q == last_x_q ? first_x_q : px_q + 1;
      if (px_q == last_x_q) py_q <= py_q + 1;
    end
    if (clear_i) depth_mem[clear_address_i] <= clear_depth_i;
    else if (drawn_o) depth_mem[address_o] <= depth_o;
  end
endmodule
