// Legal SystemVerilog that Yosys 0.23 misreads, with a warning only: a member of an element of an
// array of packed structs.
package array_of_structs_pkg;
  typedef struct packed {
    logic x;
    logic y;
  } pair_t;
endpackage

module array_of_structs (
  input  logic a_i,
  output logic q_o
);
  array_of_structs_pkg::pair_t [1:0] s;
  assign s[1].x = a_i;
  assign s[1].y = 1'b0;
  assign s[0] = '0;
  assign q_o = s[1].x;
endmodule
