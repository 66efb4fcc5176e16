// The subcommands of `resect`. Each function adds one; src/cli/command/<subcommand>_command.cpp
// defines it.
#pragma once

namespace CLI {
class App;
}

namespace resect {

void addInfoCommand(CLI::App& app);
void addLiverCommand(CLI::App& app);
void addAnatomyCommand(CLI::App& app);
void addDiscretizeCommand(CLI::App& app);
void addSurfaceCommand(CLI::App& app);
void addSweepCommand(CLI::App& app);
void addRunCommand(CLI::App& app);
void addBenchCommand(CLI::App& app);
void addRenderCommand(CLI::App& app);
void addConvertCommand(CLI::App& app);
void addReplayCommand(CLI::App& app);
void addVerifyCommand(CLI::App& app);
void addExportCommand(CLI::App& app);
void addTaskCommand(CLI::App& app);
void addReportCommand(CLI::App& app);
void addClassCommand(CLI::App& app);
void addHistoryCommand(CLI::App& app);
void addWindowCommand(CLI::App& app);

}  // namespace resect
