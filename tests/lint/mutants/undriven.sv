// A signal without a driver.
module undriven (
  input  logic a_i,
  output logic q_o
);
  logic forgotten;
  assign q_o = a_i & forgotten;
endmodule
