// resect verify: plays a recording and compares every frame with what was recorded.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "cli/command/commands.h"
#include "cli/command_output.h"
#include "cli/progress_bar.h"
#include "cli/shared_options.h"
#include "record/replay.h"

namespace resect {

void addVerifyCommand(Command app) {
  struct VerifyOptions {
    std::string file;
    int threads = 0;
    bool json = false;
  };
  auto options = std::make_shared<VerifyOptions>();
  Command command = app.subcommand("verify", "Play a recording and compare every frame with it");
  addRecordingOption(command, options->file);
  addThreadsOption(command, options->threads);
  command.flag("--json", options->json, "Print JSON");
  command.footer(
      "Exit status 1 where a frame differs: the first one is named, with the stage of the step and "
      "the field.\nExample:\n  resect verify press.resect");
  command.action([options] {
    const ThreadLimit threads(options->threads);
    const Verification proof = verify(options->file, progressBar("verify"));
    if (proof.first)
      throw error("{}: frame {} of branch {} differs, in the stage {}: {}; {}", options->file,
                  proof.first->frame, proof.first->branch, proof.first->stage, proof.first->what,
                  proof.otherProgram && proof.first->stage != "file"
                      ? fmt::format("it was recorded by {}, and this is {}, in which that "
                                    "stage computes otherwise",
                                    proof.program, programName())
                      : "the recording was changed or is damaged; take an earlier copy");
    if (options->json) {
      writeJson("-", {{"file", options->file},
                      {"frames", proof.frames},
                      {"key_states", proof.keyStates},
                      {"branches", proof.branches},
                      {"complete", proof.complete}});
      return;
    }
    fmt::print("verified {} frames, {} key {}, {} {}{}\n", proof.frames, proof.keyStates,
               proof.keyStates == 1 ? "state" : "states", proof.branches,
               proof.branches == 1 ? "branch" : "branches",
               proof.complete ? "" : "; the program ended before the recording did");
  });
}

}  // namespace resect
