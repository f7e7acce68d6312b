pineda_pkg.sv
lone.sv
gone.sv
