// The core knows no time.
#include "model/timing/units/stream.h"
