// A sample comes from anywhere: the comparison knows no scene.
#include "model/scene/scene.h"
