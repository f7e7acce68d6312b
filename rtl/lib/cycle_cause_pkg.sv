// What a unit does in a cycle, as its counters number it. In simulation alone.
//
// Twin     Cause in model/timing/counted/cycles.h.
`ifdef PINEDA_COUNTERS
package cycle_cause_pkg;
  localparam int unsigned CAUSES = 5;
  localparam logic [2:0] BUSY    = 3'd0;
  localparam logic [2:0] STARVED = 3'd1; // nothing to work on
  localparam logic [2:0] BLOCKED = 3'd2; // the next unit, or a full table, does not take it
  localparam logic [2:0] HAZARD  = 3'd3; // the stamp's address is in flight
  localparam logic [2:0] MEMORY  = 3'd4; // a memory port does not take it
endpackage
`endif
