// The subcommands of `resect`. Each function adds one subcommand. The function is defined in
// src/cli/command/<subcommand>_command.cpp.
#pragma once

#include "cli/command_line.h"

namespace resect {

void addInfoCommand(Command app);
void addLiverCommand(Command app);
void addAnatomyCommand(Command app);
void addOrganCommand(Command app);
void addDiscretizeCommand(Command app);
void addSurfaceCommand(Command app);
void addSweepCommand(Command app);
void addRunCommand(Command app);
void addBenchCommand(Command app);
void addRenderCommand(Command app);
void addConvertCommand(Command app);
void addReplayCommand(Command app);
void addVerifyCommand(Command app);
void addExportCommand(Command app);
void addTaskCommand(Command app);
void addReportCommand(Command app);
void addClassCommand(Command app);
void addHistoryCommand(Command app);
void addWindowCommand(Command app);

}  // namespace resect
