// The filters of whole pictures in shaders/shared as C++, from the same files that the GPU runs
// (optics/optics.h): how a picture is brought to another size, and how its edges are smoothed.
#pragma once

#include "optics/optics.h"

#include "generated/filters_double.h"
#include "generated/filters_float.h"
