int bits(unsigned value) { return __builtin_popcount(value); }
