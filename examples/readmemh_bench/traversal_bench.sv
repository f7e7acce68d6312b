// A bench around a traversal unit, its vectors in memories: what `pineda vectors export --readmemh` wrote of
// traversal vectors. For a unit of one's own with the same ports.
//
// +stalls: the source and the sink wait at random. Ends with the number of stamps compared, or stops at the
// first one that differs.
module traversal_bench;
`include "vectors.svh"
  localparam int MaxCycles = 1 << 20; // without a stamp: the unit hangs

  // ---- The vectors: a row a token, those of all cases behind each other
  pineda_pkg::setup_prim_t prim_mem [setup_prim_rows];
  pineda_pkg::stamp_t      stamp_mem [stamp_rows];
  logic [31:0]             rows_mem [Cases*Streams]; // of each case: of case, setup_prim, stamp
  initial begin
    if ($bits(prim) != setup_prim_bits || $bits(stamp) != stamp_bits) $fatal(1, "vectors of another design");
    $readmemh("setup_prim.hex", prim_mem);
    $readmemh("stamp.hex", stamp_mem);
    $readmemh("rows.hex", rows_mem);
  end

  // ---- The unit
  logic clk = 1'b0;
  logic rst_n = 1'b0;
  logic prim_valid, prim_ready, stamp_valid, stamp_ready;
  pineda_pkg::setup_prim_t prim;
  pineda_pkg::stamp_t stamp;
  logic idle;
  initial forever #5 clk = !clk;
  traversal_unit u_unit (
    .clk_i(clk), .rst_ni(rst_n),
    .prim_valid_i(prim_valid), .prim_ready_o(prim_ready), .prim_i(prim),
    .stamp_valid_o(stamp_valid), .stamp_ready_i(stamp_ready), .stamp_o(stamp),
    .idle_o(idle)
  );

  // ---- Prims in, one after another; a frame's state is no matter of this unit
  logic stalls;
  int prim_next, stamp_next, cycles;
  assign prim = prim_mem[prim_next < setup_prim_rows ? prim_next : 0];
  initial begin
    stalls = $test$plusargs("stalls") != 0;
    prim_valid = 1'b0;
    stamp_ready = 1'b0;
    #22 rst_n = 1'b1;
  end
  always @(posedge clk or negedge rst_n) begin
    if (!rst_n) begin
      prim_next <= 0;
      stamp_next <= 0;
      cycles <= 0;
    end else begin
      automatic int sent = prim_next + 32'(prim_valid && prim_ready);
      prim_next <= sent;
      prim_valid <= (prim_valid && !prim_ready) || (sent < setup_prim_rows && (!stalls || $urandom % 4 == 0));
      stamp_ready <= !stalls || $urandom % 4 == 0;
      cycles <= cycles + 1;
      if (stamp_valid && stamp_ready) begin
        cycles <= 0;
        check();
        stamp_next <= stamp_next + 1;
      end
      if (sent == setup_prim_rows && !prim_valid && idle && !stamp_valid) finish();
      if (cycles == MaxCycles) $fatal(1, "no stamp in %0d cycles", MaxCycles);
    end
  end

  // ---- The case and the token in it that a stamp is, for the message
  function automatic void check();
    automatic int number = stamp_next;
    automatic int of_case = 0;
    if (stamp_next < stamp_rows && stamp === stamp_mem[stamp_next]) return;
    while (of_case < Cases - 1 && number >= rows_mem[of_case*Streams+2]) begin
      number -= rows_mem[of_case*Streams+2];
      of_case++;
    end
    $display("case %0d, stamp %0d at (%0d, %0d): expected %h, got %h", of_case, number, stamp.x, stamp.y,
             stamp_mem[stamp_next], stamp);
    $fatal(1, "IT DOES NOT HOLD.");
  endfunction
  function automatic void finish();
    if (stamp_next != stamp_rows) $fatal(1, "%0d stamps, expected %0d", stamp_next, stamp_rows);
    $display("%0d cases, %0d stamps: it holds.", Cases, stamp_next);
    $finish;
  endfunction
endmodule
