#include "cli/command_output.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <ostream>

#include "io/output/atomic_file.h"

namespace resect {

void writeJson(const std::string& target, const nlohmann::ordered_json& json) {
  const std::string text =
      json.dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (target == "-") {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);  // whoever waits for it need not wait for what the command does besides
  } else
    writeFileAtomically(target, [&](std::ostream& out) { out << text; });
}

}  // namespace resect
