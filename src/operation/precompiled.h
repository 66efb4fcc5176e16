// The precompiled header of the layers from operation/ on: what base/precompiled.h has, and the
// simulation. No file includes this one by name.
#pragma once

#include "base/precompiled.h"
#include "operation/scenario.h"
