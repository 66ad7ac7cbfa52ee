#include "scene_io/load.h"
