// The mutant for check_includes.sh; never compiled.
#include "model/core/setup.h"
