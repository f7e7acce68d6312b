// Only tb/plugin.cpp sees the Verilated RTL.
#include "verilated.h"
