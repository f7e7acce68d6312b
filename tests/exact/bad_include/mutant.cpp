// The proof that check_includes.sh can fail; never compiled.
#include "model/core/setup.h"
