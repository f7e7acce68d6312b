package pineda_pkg;
  typedef struct packed {
    logic x;
  } pair_t;
endpackage
