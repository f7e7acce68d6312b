// A name that nobody declared.
module implicit (
  input  logic a_i,
  output logic q_o
);
  assign q_o = a_i & typing_error;
endmodule
