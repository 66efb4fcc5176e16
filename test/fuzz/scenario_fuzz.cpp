#include "fuzz_target.h"
#include "io/scenario/scenario_file.h"

RESECT_FUZZ_TARGET(resect::parseScenario(std::string(bytes), "input.toml"))
