#include "integrators/render.h"
