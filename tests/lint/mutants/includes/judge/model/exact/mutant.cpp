// The judge uses nothing of the project.
#include "model/spec/fixed.h"
