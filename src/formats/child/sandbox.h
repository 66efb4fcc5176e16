// Takes from the present process every right that a reader of foreign files does not need.
//
// It is meant for a forked child that already has the bytes of its file in memory
// (formats/child/child_process.h). It works on Linux only. The sandbox consists of several
// mechanisms ("walls"); docs/security.md says what each one stops.
#pragma once

#include <string>

namespace resect {

// The two walls that the kernel must provide. Tests switch one off to see what the other one stops.
struct SandboxWalls {
  // Landlock. Refuses access to files (Linux 5.13 and later), TCP (6.7 and later) and signals to
  // other processes (6.12 and later).
  bool landlock = true;
  bool systemCalls = true;  // seccomp: allows only calls for computing and answering
};

// Enters the sandbox, for good. Of the open files only `answerPipe` stays open; standard input,
// output and error become /dev/null. Environment, capabilities and the right to gain privileges are
// gone. No process can be started, no file opened, no socket made, no memory made executable. A
// refused call fails with EPERM or EACCES. The process must have only one thread. Cost: 0.3 ms.
//
// Sanitized builds keep standard output and standard error, since the sanitizers report there.
void enterSandbox(int answerPipe, const SandboxWalls& walls = {});

// A sentence for the user about those of the two walls that this kernel lacks; empty if it has
// both.
std::string missingWalls();

}  // namespace resect
