pineda_pkg.sv
memory.sv
