// Replays test vectors on the netlist of one unit; `pineda study netlist` gives it the parameters, by
// model/spec, and unit.svh, which joins the netlist's ports to the signals here.
//
// In       +vectors=FILE: a line "0 FRAME CLEAR_DEPTH WIDTH HEIGHT DEPTH DEPTH_WRITE" starts a case, a
//          line "1 TOKEN" is offered to the unit; all in hex. +seed=N: of the stalls.
// Out      lines on standard output: "out STREAM CYCLE TOKEN", each token as it is taken; "done CYCLE"
//          when a case has been through; "fault CYCLE TEXT", after which nothing comes; "end".
// Rate     a cycle in four is stalled at the source, at each sink and at the memory's responses.
//
// All is looked at just before the edge of the clock and changed just after it.
`timescale 1ns / 1ps

`define WAIT_CYCLES 20000  // without a handshake: a unit that hangs
`define STALL(SEED) ($unsigned($random(SEED)) % 4 == 0)

// Takes a stream: prints its tokens, and sees to it that what is offered stays.
module sink #(parameter Bits = 1, parameter Name = "") (
  input  wire            look_i,
  input  wire            rst_ni,
  input  wire [31:0]     cycle_i,
  input  wire [31:0]     seed_i,
  input  wire            valid_i,
  output reg             ready_o,
  input  wire [Bits-1:0] token_i,
  output wire            taken_o,
  output reg             fault_o
);
  integer seed;
  reg waits;
  reg [Bits-1:0] last;
  initial begin
    ready_o = 0;
    fault_o = 0;
    waits = 0;
  end
  assign taken_o = valid_i === 1 && ready_o;
  always @(posedge look_i) begin
    if (!rst_ni) begin
      seed = seed_i;
    end else begin
      if (valid_i !== 0 && valid_i !== 1) begin
        $display("fault %0d %0s: valid is %b", cycle_i, Name, valid_i);
        fault_o = 1;
      end
      if (waits && (valid_i !== 1 || token_i !== last)) begin
        $display("fault %0d %0s: it is not stable while it waits", cycle_i, Name);
        fault_o = 1;
      end
      if (taken_o) $display("out %0s %0d %h", Name, cycle_i, token_i);
      waits = valid_i === 1 && !ready_o;
      last = token_i;
      ready_o <= #2 !`STALL(seed);
    end
  end
endmodule

module netlist_bench;
  parameter FrameBits = 1;
  parameter InBits = 1;   // of the stream into the unit
  parameter OutBits = 1;  // of the stream out of it; of interpolation: its colour writes
  // Of the depth memory's ports: how wide they are, and where fields lie.
  parameter ReadBits = 1, ReadX = 0, ReadY = 0, ReadMask = 0;
  parameter WriteBits = 1, WriteX = 0, WriteY = 0, WriteMask = 0, WriteZ = 0;
  parameter XBits = 1, YBits = 1, WidthLog2 = 0, HeightLog2 = 0, DepthBits = 1;
  localparam Lanes = 1 << (WidthLog2 + HeightLog2);
  localparam Latency = 5;  // of a depth read, cycles
  localparam Pending = 64;
  localparam Slots = 65536;  // more samples than a case touches
  localparam [31:0] Free = 32'hffffffff;

  // unit.svh joins bits of vectors when they have settled: as nets, wide ones would be computed anew
  // for each bit that changes.
  reg settled = 0, look = 0, clk = 0, rst_n = 0;
  always begin
    #7 settled = 1;
    #1 look = 1;
    #1 clk = 1;
    #1 settled = 0;
    look = 0;
    #4 clk = 0;
  end

  reg [FrameBits-1:0] frame = 0;
  reg [3:0] depth_func = 0;
  reg depth_write = 0;
  reg [InBits-1:0] token = 0;
  reg valid = 0;
  wire ready, idle;
  wire out_valid, out_ready;
  reg [OutBits-1:0] out;
  wire read_valid, read_ready, write_valid, write_ready, response_ready;
  reg [ReadBits-1:0] read;
  reg [WriteBits-1:0] write;
  reg response_valid = 0;
  reg [Lanes*DepthBits-1:0] response = 0;

`include "unit.svh"

  reg [31:0] cycle = 0, seed = 1;
  wire out_taken, read_taken, write_taken, out_fault, read_fault, write_fault;
  sink #(.Bits(OutBits), .Name(OUT_NAME)) u_out (
    .look_i(look), .rst_ni(rst_n), .cycle_i(cycle), .seed_i(seed + 1),
    .valid_i(out_valid), .ready_o(out_ready), .token_i(out), .taken_o(out_taken),
    .fault_o(out_fault)
  );
  sink #(.Bits(ReadBits), .Name("depth_read")) u_reads (
    .look_i(look), .rst_ni(rst_n), .cycle_i(cycle), .seed_i(seed + 2),
    .valid_i(read_valid), .ready_o(read_ready), .token_i(read), .taken_o(read_taken),
    .fault_o(read_fault)
  );
  sink #(.Bits(WriteBits), .Name("depth_write")) u_writes (
    .look_i(look), .rst_ni(rst_n), .cycle_i(cycle), .seed_i(seed + 3),
    .valid_i(write_valid), .ready_o(write_ready), .token_i(write), .taken_o(write_taken),
    .fault_o(write_fault)
  );

  // The depth memory: a slot for each sample that was touched. A read sees the writes of earlier cycles;
  // there is nothing outside the frame.
  reg [DepthBits-1:0] memory [0:Slots-1];
  reg [31:0] owner [0:Slots-1];  // the sample's number in its frame
  integer taken [0:Slots-1], slots_taken = 0, slot;
  initial for (slot = 0; slot < Slots; slot = slot + 1) owner[slot] = Free;
  reg [Lanes*DepthBits-1:0] answer [0:Pending-1];
  reg [31:0] due [0:Pending-1];
  integer asked = 0, answered = 0, memory_seed = 4, lane, x, y;
  reg [31:0] width = 0, height = 0, cleared = 0;
  reg [Lanes*DepthBits-1:0] found;

  // The slot of the sample at (x, y), cleared if it is new.
  task find_slot;
    begin
      slot = (y * width + x) % Slots;
      while (owner[slot] != y * width + x && owner[slot] != Free) slot = (slot + 1) % Slots;
      if (owner[slot] == Free) begin
        owner[slot] = y * width + x;
        memory[slot] = cleared;
        taken[slots_taken] = slot;
        slots_taken = slots_taken + 1;
      end
    end
  endtask

  always @(posedge look) begin
    if (response_valid && response_ready === 1) begin
      answered = answered + 1;
      response_valid <= #2 0;
    end
    if (read_taken) begin
      found = 0;
      for (lane = 0; lane < Lanes; lane = lane + 1) begin
        x = (read[ReadX+:XBits] << WidthLog2) + lane % (1 << WidthLog2);
        y = (read[ReadY+:YBits] << HeightLog2) + lane / (1 << WidthLog2);
        if (read[ReadMask+lane] && x < width && y < height) begin
          find_slot;
          found[lane*DepthBits+:DepthBits] = memory[slot];
        end
      end
      answer[asked%Pending] = found;
      due[asked%Pending] = cycle + Latency;
      asked = asked + 1;
    end
    if (write_taken) begin
      for (lane = 0; lane < Lanes; lane = lane + 1) begin
        x = (write[WriteX+:XBits] << WidthLog2) + lane % (1 << WidthLog2);
        y = (write[WriteY+:YBits] << HeightLog2) + lane / (1 << WidthLog2);
        if (write[WriteMask+lane] && x < width && y < height) begin
          find_slot;
          memory[slot] = write[WriteZ+lane*DepthBits+:DepthBits];
        end
      end
    end
    if ((!response_valid || response_ready === 1) && answered < asked &&
        due[answered%Pending] <= cycle && !`STALL(memory_seed)) begin
      response <= #2 answer[answered%Pending];
      response_valid <= #2 1;
    end
  end

  // The source.
  localparam Start = 0, Token = 1, End = 2;
  integer file, kind, got, source_seed;
  reg [InBits-1:0] next_token;
  reg [FrameBits-1:0] next_frame;
  reg [31:0] clear_depth, next_width, next_height, next_func, next_write, moved = 0;
  reg in_case = 0;
  reg [8*4096-1:0] path;

  task next_line;
    begin
      got = $fscanf(file, "%h", kind);
      if (got != 1) kind = End;
      if (kind == Token) got = $fscanf(file, "%h", next_token);
      if (kind == Start) begin
        got = $fscanf(file, "%h %h %h %h %h %h", next_frame, clear_depth, next_width, next_height,
                      next_func, next_write);
      end
    end
  endtask

  task start_case;
    begin
      in_case = 1;
      frame <= #2 next_frame;
      depth_func <= #2 next_func;
      depth_write <= #2 next_write;
      width = next_width;
      cleared = clear_depth;
      height = next_height;
      while (slots_taken > 0) begin
        slots_taken = slots_taken - 1;
        owner[taken[slots_taken]] = Free;
      end
      next_line;
    end
  endtask

  task look_for_faults;
    begin
      if (out_fault || read_fault || write_fault) $finish;
      if (idle !== 0 && idle !== 1) begin
        $display("fault %0d idle_o is %b", cycle, idle);
        $finish;
      end
      if (valid && ready !== 0 && ready !== 1) begin
        $display("fault %0d the input's ready is %b", cycle, ready);
        $finish;
      end
      if ((valid && ready) || out_taken || read_taken || write_taken) moved = cycle;
      if (cycle - moved > `WAIT_CYCLES) begin
        $display("fault %0d nothing moves since cycle %0d", cycle, moved);
        $finish;
      end
    end
  endtask

  initial begin
    got = $value$plusargs("vectors=%s", path);
    got = $value$plusargs("seed=%d", seed);
    source_seed = seed;
    file = $fopen(path, "r");
    next_line;
    #32 rst_n <= 1;
  end

  always @(posedge look) if (rst_n) begin
    look_for_faults;
    if (kind != Token && !valid && idle === 1) begin
      if (in_case) $display("done %0d", cycle);
      if (kind == End) begin
        $display("end");
        $finish;
      end
      start_case;
    end else if (!valid || ready === 1) begin
      valid <= #2 0;
      if (kind == Token && !`STALL(source_seed)) begin
        valid <= #2 1;
        token <= #2 next_token;
        next_line;
      end
    end
    cycle <= cycle + 1;
  end
endmodule
