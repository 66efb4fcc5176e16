// Takes from this process all that a reader of foreign files does not need.
//
// For a forked child that already has its file's bytes in memory (formats/child_process.h). Linux
// only. What each wall stops: docs/security.md.
#pragma once

#include <string>

namespace resect {

// The walls that need the kernel's help; tests take one away to see what the other holds.
struct SandboxWalls {
  bool landlock = true;     // no file, no TCP, no signal to others; Linux 5.13, 6.7 and 6.12
  bool systemCalls = true;  // seccomp: only the calls that computing and answering need
};

// Enters the sandbox, for ever. Only `answerPipe` stays open besides standard input, output and
// error, which become /dev/null. Environment, capabilities and the right to gain privileges are
// gone; no process can be started, no file opened, no socket made, no memory made executable. A
// refused call fails with EPERM or EACCES. Call it in a process with one thread. 0.3 ms.
//
// Sanitized builds keep standard error, since their reports go there.
void enterSandbox(int answerPipe, const SandboxWalls& walls = {});

// The walls that this kernel lacks, as a sentence for the user; empty if it has both.
std::string missingWalls();

}  // namespace resect
