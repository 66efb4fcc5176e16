#include "fuzz_target.h"
#include "io/scenario/scenario_file.h"

RESECT_FUZZ_TARGET(resect::parseTool(std::string(bytes), "input.toml",
                                     [](const auto&) { return resect::TriangleMesh(); }))
