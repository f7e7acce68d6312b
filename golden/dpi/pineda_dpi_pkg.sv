// The golden model in a SystemVerilog bench, by DPI-C and 2-state types. Needs the design's pineda_pkg,
// pineda_dpi.c and libpineda_golden.
//
// Errors   whatever the model refuses ends the simulation with the line that it says.
package pineda_dpi_pkg;
  typedef bit [$bits(pineda_pkg::frame_t)-1:0]      frame_bits_t;
  typedef bit [$bits(pineda_pkg::triangle_t)-1:0]   triangle_bits_t;
  typedef bit [$bits(pineda_pkg::setup_prim_t)-1:0] setup_prim_bits_t;
  typedef bit [$bits(pineda_pkg::stamp_t)-1:0]      stamp_bits_t;

  import "DPI-C" function chandle pineda_dpi_open(
    input string name, input int frame_bits, input int triangle_bits, input int setup_prim_bits,
    input int stamp_bits);
  import "DPI-C" function void pineda_dpi_close(input chandle model);
  import "DPI-C" function string pineda_dpi_error();
  import "DPI-C" function int pineda_dpi_setup(
    input chandle model, input frame_bits_t frame, input triangle_bits_t triangle,
    output setup_prim_bits_t prim);
  import "DPI-C" function int pineda_dpi_traverse(input chandle model, input setup_prim_bits_t prim);
  import "DPI-C" function int pineda_dpi_next_stamp(input chandle model, output stamp_bits_t stamp);

  // A model of a design by name, or of the text of a design file.
  function automatic chandle open(input string name);
    chandle model = pineda_dpi_open(name, $bits(frame_bits_t), $bits(triangle_bits_t),
                                    $bits(setup_prim_bits_t), $bits(stamp_bits_t));
    if (model == null) $fatal(1, "pineda_dpi: %s", pineda_dpi_error());
    return model;
  endfunction

  // Setup of a triangle; 0 where it is dropped.
  function automatic bit setup(input chandle model, input frame_bits_t frame,
                               input triangle_bits_t triangle, output setup_prim_bits_t prim);
    int drop = pineda_dpi_setup(model, frame, triangle, prim);
    if (drop < 0) $fatal(1, "pineda_dpi: %s", pineda_dpi_error());
    return drop == 0;
  endfunction

  // The stamps of a triangle are added to those that next_stamp() gives; returns how many.
  function automatic int traverse(input chandle model, input setup_prim_bits_t prim);
    int stamps = pineda_dpi_traverse(model, prim);
    if (stamps < 0) $fatal(1, "pineda_dpi: %s", pineda_dpi_error());
    return stamps;
  endfunction

  // The next stamp in order; 0 where there is none.
  function automatic bit next_stamp(input chandle model, output stamp_bits_t stamp);
    int is_there = pineda_dpi_next_stamp(model, stamp);
    if (is_there < 0) $fatal(1, "pineda_dpi: %s", pineda_dpi_error());
    return is_there == 1;
  endfunction
endpackage
