// The precompiled header of all tests: besides that of the library, doctest and what most tests
// look at. It halves the time that the tests take to compile. No file includes this one by name.
#pragma once

#include <doctest/doctest.h>

#include "base/precompiled.h"
#include "simulation/simulation.h"
