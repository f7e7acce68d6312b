lone.sv
pineda_pkg.sv
