// The precompiled header of the layers from operation/ on: base/precompiled.h and the simulation.
// No file includes this header by name.
#pragma once

#include "base/precompiled.h"
#include "operation/scenario.h"
