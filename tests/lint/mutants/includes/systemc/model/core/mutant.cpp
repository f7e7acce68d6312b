// The core knows no SystemC.
#include <systemc>
