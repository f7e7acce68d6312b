// What judges compares with core.
#include "model/fast/renderer.h"
