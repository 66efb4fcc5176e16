// The command line of Resect: parses, calls one subcommand, turns errors into one sentence and an
// exit status.

#include <resect/version.h>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include "base/error.h"
#include "base/kept_memory.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/process/end_by_signal.h"
#include "cli/process/standard_streams.h"
#include "formats/child/sandbox.h"

namespace {

constexpr const char* kExamples = R"(
Examples:
  resect window                                   operate with the mouse
  resect run resect-segment --frames pictures     cut the left lateral part off the built-in liver
  resect run cut --organ my_liver.stl --json -    the same tools on an organ of your own
  resect bench                                    how large an organ keeps real time here?
  resect info my_liver.stl                        is this mesh fit to be an organ?
  resect discretize my_liver.stl --spacing 5mm -o my_liver.dis
  resect surface my_liver.dis -o surface.obj
  resect render surface.obj -o surface.png

Lengths take units: 5mm, 0.5cm, 0.005m. Exit status: 0 done, 1 failed, 2 wrong usage.)";

// All errors leave the program here.
int complain(std::string_view sentence, int status) {
  resect::printLine(stderr, "resect: error: {}", resect::shownSentence(sentence));
  return status;
}

// An empty value is a slip, as of a variable that a script did not set; it is not the same as none.
void refuseEmptyValues(CLI::App& app) {
  const CLI::Validator full(
      [](std::string& value) {
        const bool blank = value.find_first_not_of(" \t\r\n") == value.npos;
        return std::string(blank ? "the value is empty; give one, or leave the option out" : "");
      },
      "");
  for (CLI::App* command : app.get_subcommands({}))
    for (CLI::Option* option : command->get_options())
      if (option->get_items_expected_max() > 0) option->check(full);
}

int parseAndRun(int argc, char** argv) {
  CLI::App app("Resect: virtual surgery on organ models, in real time, headless or in a window",
               "resect");
  app.footer(kExamples);
  app.require_subcommand(1);
  app.set_version_flag("--version", RESECT_VERSION);
  app.failure_message([](const CLI::App* failed, const CLI::Error& e) {
    std::string command = failed->get_name();
    for (const CLI::App* sub : failed->get_subcommands()) command += " " + sub->get_name();
    complain(fmt::format("{}; see {} --help", e.what(), command), 2);
    return std::string();
  });
  const resect::Command command(&app);
  resect::addInfoCommand(command);
  resect::addLiverCommand(command);
  resect::addAnatomyCommand(command);
  resect::addOrganCommand(command);
  resect::addDiscretizeCommand(command);
  resect::addSurfaceCommand(command);
  resect::addRunCommand(command);
  resect::addBenchCommand(command);
  resect::addRenderCommand(command);
  resect::addConvertCommand(command);
  resect::addReplayCommand(command);
  resect::addVerifyCommand(command);
  resect::addExportCommand(command);
  resect::addTaskCommand(command);
  resect::addReportCommand(command);
  resect::addClassCommand(command);
  resect::addHistoryCommand(command);
  resect::addSweepCommand(command);
  resect::addWindowCommand(command);
  refuseEmptyValues(app);
  const auto named = [&](CLI::App* command) { return command->get_name() == argv[1]; };
  if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(named).empty())
    throw resect::usageError("there is no command \"{}\"; see resect --help", argv[1]);
  try {
    if (const std::string lack = resect::missingWalls(); !lack.empty())
      resect::printLine(stderr, "resect: note: {}", lack);
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
}

}  // namespace

int main(int argc, char** argv) {
  resect::openStandardStreams();
  resect::cleanUpOnSignals();
  resect::keepFreedMemory();
  try {
    const int status = parseAndRun(argc, argv);
    resect::finishStandardOutput();
    return status;
  } catch (const resect::Error& e) {
    return complain(e.what(), int(e.status()));
  } catch (const std::bad_alloc&) {
    return complain("out of memory; use a larger spacing or a smaller model", 1);
  } catch (const std::exception& e) {
    if (std::ferror(stdout))
      return complain("cannot write to standard output; what was printed is not complete", 1);
    return complain(e.what(), 1);
  }
}
