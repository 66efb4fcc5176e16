// The precompiled header of the layer operation/ and of some layers above it: base/precompiled.h,
// and the headers of the simulation. No file includes this header by name.
#pragma once

#include "base/precompiled.h"
#include "operation/scenario.h"
