// Setup and traversal of the RTL against the golden model by DPI, at both boundaries and in order, with
// random back-pressure.
//
// +seed=N        of the triangles and of the stalls
// +triangles=N   to be sent, 400 unless given
// +stall=P       percent of the cycles in which a port stalls, 30 unless given
// +trace=FILE    a waveform
module dpi_bench;
  import pineda_dpi_pkg::*;
  localparam int Size = 64;          // px: a frame of Size x Size
  localparam int Patience = 100_000; // cycles without a token

  logic clk = 1'b0;
  logic rst_n = 1'b0;
  initial forever #5 clk = !clk;
  initial #22 rst_n = 1'b1;

  // ---- The units: triangles in, stamps out; a stall holds the stream between them as well
  pineda_pkg::frame_t frame;
  pineda_pkg::triangle_t triangle;
  pineda_pkg::setup_prim_t prim;
  pineda_pkg::stamp_t stamp;
  logic tri_valid, tri_ready, prim_valid, prim_ready, stamp_valid, stamp_ready, hold, setup_idle, idle;
  setup_unit u_setup (
    .clk_i(clk), .rst_ni(rst_n), .frame_i(frame),
    .tri_valid_i(tri_valid), .tri_ready_o(tri_ready), .tri_i(triangle),
    .prim_valid_o(prim_valid), .prim_ready_i(prim_ready && !hold), .prim_o(prim), .idle_o(setup_idle)
  );
  traversal_unit u_traversal (
    .clk_i(clk), .rst_ni(rst_n),
    .prim_valid_i(prim_valid && !hold), .prim_ready_o(prim_ready), .prim_i(prim),
    .stamp_valid_o(stamp_valid), .stamp_ready_i(stamp_ready), .stamp_o(stamp), .idle_o(idle)
  );

  bind setup_unit stream_rules #(.Bits($bits(prim_o))) u_prim_rules (
    .clk_i, .rst_ni, .valid_i(prim_valid_o), .ready_i(prim_ready_i), .data_i(prim_o)
  );
  bind traversal_unit stream_rules #(.Bits($bits(stamp_o))) u_stamp_rules (
    .clk_i, .rst_ni, .valid_i(stamp_valid_o), .ready_i(stamp_ready_i), .data_i(stamp_o)
  );

  // ---- Stimulus
  int seed = 1, triangles = 400, stall = 30;
  int sent, prims, stamps, quiet;
  string trace;
  function automatic bit stalls();
    return $urandom_range(99) < 32'(stall);
  endfunction
  // From a subpixel to the whole frame; every other one on the lattice of half pixels, where edges meet samples.
  function automatic pineda_pkg::triangle_t random_triangle(int id);
    pineda_pkg::triangle_t t = '0;
    int step = $urandom_range(1) == 0 ? 1 : 128;
    int reach = 1 << $urandom_range(14);
    int x = int'($urandom_range(Size*256)), y = int'($urandom_range(Size*256));
    t.id = 32'(id);
    for (int i = 0; i < 3; i++) begin
      t.x[i*pineda_pkg::COORD_BITS +: pineda_pkg::COORD_BITS] = near(x, reach, step);
      t.y[i*pineda_pkg::COORD_BITS +: pineda_pkg::COORD_BITS] = near(y, reach, step);
      t.z[i*pineda_pkg::DEPTH_IN_BITS +: pineda_pkg::DEPTH_IN_BITS] = $urandom % 32'hffffff01;
    end
    for (int i = 0; i < 12; i++) t.attr[8*i +: 8] = 8'($urandom);
    return t;
  endfunction
  function automatic bit [pineda_pkg::COORD_BITS-1:0] near(int at, int reach, int step);
    return pineda_pkg::COORD_BITS'((at + int'($urandom_range(2*reach)) - reach) / step * step);
  endfunction
  initial begin
    void'($value$plusargs("seed=%d", seed));
    void'($value$plusargs("triangles=%d", triangles));
    void'($value$plusargs("stall=%d", stall));
    void'($urandom(seed));
    if ($value$plusargs("trace=%s", trace)) begin $dumpfile(trace); $dumpvars; end
    model = open("high_tile");
    frame = '0;
    frame.width = 15'(Size);
    frame.height = 15'(Size);
    frame.clip_x1 = 15'(Size);
    frame.clip_y1 = 15'(Size);
  end

  // ---- Scoreboard: what the model made of each token that was taken, in order
  chandle model;
  setup_prim_bits_t expected_prims[$];
  function automatic void check_prim();
    setup_prim_bits_t expected = '0;
    if (expected_prims.size() > 0) expected = expected_prims.pop_front();
    if (expected != prim) $fatal(1, "prim %0d: expected %h, got %h", prims, expected, prim);
    void'(traverse(model, prim));
  endfunction
  function automatic void check_stamp();
    stamp_bits_t expected;
    void'(next_stamp(model, expected));
    if (expected != stamp) $fatal(1, "stamp %0d: expected %h, got %h", stamps, expected, stamp);
  endfunction
  function automatic void finish();
    stamp_bits_t none;
    if (expected_prims.size() > 0 || next_stamp(model, none)) $fatal(1, "a token is missing");
    $display("%0d triangles, %0d prims, %0d stamps: it holds.", sent, prims, stamps);
    $finish;
  endfunction

  always @(posedge clk or negedge rst_n) if (!rst_n) begin
    {tri_valid, stamp_ready, hold} <= '0;
    {sent, prims, stamps, quiet} <= '0;
  end else begin
    quiet <= quiet + 1;
    if (tri_valid && tri_ready) begin
      automatic setup_prim_bits_t expected;
      if (setup(model, frame, triangle, expected)) expected_prims.push_back(expected);
      sent <= sent + 1;
    end
    if (prim_valid && prim_ready && !hold) begin check_prim(); prims <= prims + 1; quiet <= 0; end
    if (stamp_valid && stamp_ready) begin check_stamp(); stamps <= stamps + 1; quiet <= 0; end
    if (!tri_valid || tri_ready) begin
      tri_valid <= sent + 32'(tri_valid) < triangles && !stalls();
      triangle <= random_triangle(sent + 32'(tri_valid));
    end
    stamp_ready <= !stalls();
    // Valid must not be taken back, so a stream is held only from the moment on in which it is empty.
    hold <= (!prim_valid || (prim_ready && !hold) || hold) && stalls();
    if (sent == triangles && setup_idle && idle && !prim_valid && !stamp_valid) finish();
    if (quiet == Patience) $fatal(1, "no token in %0d cycles", Patience);
  end
endmodule
