#include "formats/child/sandbox.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "base/error.h"

namespace resect {
namespace {

// Landlock's interface, written out because Debian 12's headers know version 2 only (Linux
// Documentation/userspace-api/landlock.rst, version 7).
struct LandlockRules {
  std::uint64_t files;    // actions on files that are refused
  std::uint64_t network;  // since version 4: TCP bind and connect
  std::uint64_t scoped;   // since version 6: abstract sockets and signals
};
constexpr long kCreateRuleset = 444, kRestrictSelf = 446;
constexpr unsigned kAskVersion = 1;

int landlockVersion() { return int(::syscall(kCreateRuleset, nullptr, 0, kAskVersion)); }

void refuseFiles() {
  const int version = landlockVersion();
  if (version < 1) return;
  // Thirteen actions on files in version 1, then one more each: moving (2), truncating (3) and
  // device control (5).
  const int actions = 13 + (version >= 2) + (version >= 3) + (version >= 5);
  LandlockRules rules{};
  rules.files = (std::uint64_t(1) << actions) - 1;
  std::size_t size = sizeof rules.files;
  if (version >= 4) {
    rules.network = 3;
    size += sizeof rules.network;
  }
  if (version >= 6) {
    rules.scoped = 3;
    size += sizeof rules.scoped;
  }
  const long ruleset = ::syscall(kCreateRuleset, &rules, size, 0);
  if (ruleset < 0 || ::syscall(kRestrictSelf, ruleset, 0) != 0)
    throw error("the sandbox of file readers cannot be made (Landlock: {}); report this",
                std::strerror(errno));
  ::close(int(ruleset));
}

// What computing needs, memory above all, and the answer's pipe.
constexpr int kAllowed[] = {SCMP_SYS(brk),
                            SCMP_SYS(munmap),
                            SCMP_SYS(mremap),
                            SCMP_SYS(madvise),
                            SCMP_SYS(futex),
                            SCMP_SYS(clock_gettime),
                            SCMP_SYS(gettimeofday),
                            SCMP_SYS(getrandom),
                            SCMP_SYS(getpid),
                            SCMP_SYS(gettid),
                            SCMP_SYS(rt_sigreturn),
                            SCMP_SYS(rt_sigprocmask),
                            SCMP_SYS(rt_sigaction),
                            SCMP_SYS(sigaltstack),
                            SCMP_SYS(sched_yield),
                            SCMP_SYS(exit),
                            SCMP_SYS(exit_group),
                            SCMP_SYS(close),
                            SCMP_SYS(restart_syscall),
                            SCMP_SYS(clock_nanosleep)};

void refuseSystemCalls(int answerPipe) {
  scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (!filter) throw std::bad_alloc();
  int failed = 0;
  const auto allow = [&](int call) {
    failed |= ::seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call, 0, nullptr);
  };
  const auto allowIf = [&](int call, scmp_arg_cmp condition) {
    failed |= ::seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call, 1, &condition);
  };
  for (const int call : kAllowed) allow(call);
  allowIf(SCMP_SYS(write), SCMP_A0(SCMP_CMP_EQ, scmp_datum_t(answerPipe)));
#ifdef RESECT_SANITIZED
  allowIf(SCMP_SYS(write), SCMP_A0(SCMP_CMP_EQ, STDERR_FILENO));
#endif
  // No memory that can be executed, so that planted code cannot be run.
  allowIf(SCMP_SYS(mmap), SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0));
  allowIf(SCMP_SYS(mprotect), SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0));
  // abort() sends a signal to itself.
  allowIf(SCMP_SYS(tgkill), SCMP_A0(SCMP_CMP_EQ, scmp_datum_t(::getpid())));
  if (failed == 0) failed = ::seccomp_load(filter);
  ::seccomp_release(filter);
  if (failed != 0)
    throw error("the sandbox of file readers cannot be made (seccomp: {}); report this",
                std::strerror(-failed));
}

void dropCapabilities() {
  for (int capability = 0; ::prctl(PR_CAPBSET_READ, capability, 0, 0, 0) >= 0; ++capability)
    ::prctl(PR_CAPBSET_DROP, capability, 0, 0, 0);
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct none[2]{};
  ::syscall(SYS_capset, &header, none);
}

void eraseEnvironment() {
  for (char** variable = environ; variable && *variable; ++variable)
    ::explicit_bzero(*variable, std::strlen(*variable));
  ::clearenv();
}

void closeAllBut(int answerPipe) {
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nowhere, STDIN_FILENO);
#ifndef RESECT_SANITIZED
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
#endif
  ::close_range(STDERR_FILENO + 1, unsigned(answerPipe) - 1, 0);
  ::close_range(unsigned(answerPipe) + 1, ~0U, 0);
}

void refuse(decltype(RLIMIT_CPU) resource) {
  const rlimit none{0, 0};
  ::setrlimit(resource, &none);
}

bool kernelHasSeccomp() {
  const std::uint32_t action = SECCOMP_RET_ERRNO;
  return ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

}  // namespace

void enterSandbox(int answerPipe, const SandboxWalls& walls) {
  eraseEnvironment();
  closeAllBut(answerPipe);
  ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
  dropCapabilities();
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
    throw error("the sandbox of file readers cannot be made (privileges: {}); report this",
                std::strerror(errno));
  if (walls.landlock) refuseFiles();
  for (const auto resource : {RLIMIT_CORE, RLIMIT_FSIZE, RLIMIT_NPROC, RLIMIT_NOFILE})
    refuse(resource);
  if (walls.systemCalls && kernelHasSeccomp()) refuseSystemCalls(answerPipe);
}

std::string missingWalls() {
  std::string names;
  if (landlockVersion() < 1) names = "Landlock";
  if (!kernelHasSeccomp()) names += names.empty() ? "seccomp" : " and seccomp";
  if (names.empty()) return {};
  return fmt::format(
      "this kernel has no {}, so files of others are read behind fewer walls; see docs/security.md",
      names);
}

}  // namespace resect
