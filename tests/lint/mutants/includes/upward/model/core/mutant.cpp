// The core knows no time.
#include "model/timing/stream.h"
