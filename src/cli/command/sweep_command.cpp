// resect sweep: hands over to the sweeps of the Python package, python/resect/sweep.

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/command/commands.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

// The Python that has the package: the one that RESECT_PYTHON names, that of the virtual
// environment of tools/python_env.sh beside this build, else Debian's.
std::string findPython() {
  if (const char* named = std::getenv("RESECT_PYTHON"); named && *named) return named;
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  if (!failed)
    if (const fs::path own = program.parent_path().parent_path() / "python" / "bin" / "python";
        fs::exists(own, failed))
      return own.string();
  return "/usr/bin/python3";
}

// What Python runs: a sentence where the package is missing, else the package's module.
constexpr const char* kStart =
    "import importlib.util, runpy, sys\n"
    "if not importlib.util.find_spec('resect') or not importlib.util.find_spec('resect.sweep'):\n"
    "    sys.exit('resect: error: ' + sys.executable + ' has no package resect; make it by '\n"
    "             'tools/python_env.sh, or name another Python by RESECT_PYTHON')\n"
    "runpy.run_module('resect.sweep', run_name='__main__', alter_sys=True)\n";

[[noreturn]] void handOver(const std::vector<std::string>& arguments) {
  const std::string python = findPython();
  std::vector<std::string> words = {python, "-c", kStart};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(python.c_str(), pointers.data());
  throw error("{} cannot be started: {}; make the Python package by tools/python_env.sh", python,
              std::strerror(errno));
}

}  // namespace

void addSweepCommand(Command app) {
  const Command command = app.subcommand(
      "sweep", "Run many operations that differ in some settings: one table in, one table out");
  command.passOn(handOver);  // Python has the help too
  command.footer(
      "Examples:\n"
      "  resect sweep stiffness.toml -o stiffness.csv\n"
      "  resect sweep stiffness.toml --dask tcp://host:8786\n"
      "  resect sweep stiffness.toml --verify 20");
}

}  // namespace resect
