// Takes away from the present process all rights that a reader of foreign files does not need.
//
// This is meant for a forked child that already has the bytes of its file in memory
// (formats/child/child_process.h). It works only on Linux. The sandbox consists of several
// mechanisms ("walls"); docs/security.md says what each one stops.
#pragma once

#include <string>

namespace resect {

// The two walls that depend on the version of the kernel. A test can switch one of them off to see
// what the other one stops.
struct SandboxWalls {
  // Landlock. Refuses access to files (Linux 5.13 and later), TCP (6.7 and later) and signals to
  // other processes (6.12 and later).
  bool landlock = true;
  bool systemCalls = true;  // seccomp: allows only calls for computing and answering
};

// Enters the sandbox. The process can never leave it. All open files are closed, except
// `answerPipe`. Standard input, output and error become /dev/null. The process loses its
// environment, its capabilities, and the right to gain privileges. It can no longer start a
// process, open a file, make a socket, or make memory executable. A refused call fails with EPERM
// or EACCES. The process must have only one thread. Cost: 0.3 ms.
//
// Sanitized builds keep standard output and standard error, since the sanitizers report there.
void enterSandbox(int answerPipe, const SandboxWalls& walls = {});

// A sentence for the user that names the walls which this kernel lacks; empty if the kernel has
// both walls.
std::string missingWalls();

}  // namespace resect
