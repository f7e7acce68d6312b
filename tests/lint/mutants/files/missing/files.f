pineda_pkg.sv
