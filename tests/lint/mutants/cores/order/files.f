a.sv
b.sv
