// Paths start at the root.
#include "setup.h"
