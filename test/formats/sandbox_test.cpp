#include "formats/child/sandbox.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "formats/child/child_process.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

struct Attempt {
  std::string name;
  std::function<long()> act;  // negative: refused
};

// What planted code would try. `victim`: a file of ours; `socket`: a descriptor of the parent.
std::vector<Attempt> attempts(const std::string& victim, int socket) {
  return {{"open to read", [=] { return ::open(victim.c_str(), O_RDONLY); }},
          {"open to write", [=] { return ::open(victim.c_str(), O_WRONLY | O_TRUNC); }},
          {"create", [=] { return ::open((victim + "2").c_str(), O_CREAT | O_WRONLY, 0600); }},
          {"truncate", [=] { return ::truncate(victim.c_str(), 0); }},
          {"rename", [=] { return ::rename(victim.c_str(), (victim + "3").c_str()); }},
          {"make a folder", [=] { return ::mkdir((victim + "4").c_str(), 0700); }},
          {"link", [=] { return ::symlink(victim.c_str(), (victim + "5").c_str()); }},
          {"unlink", [=] { return ::unlink(victim.c_str()); }},
          {"internet socket", [] { return ::socket(AF_INET, SOCK_STREAM, 0); }},
          {"local socket", [] { return ::socket(AF_UNIX, SOCK_STREAM, 0); }},
          {"write to the parent's descriptor", [=] { return ::write(socket, "x", 1); }},
          {"kill the parent", [] { return ::kill(::getppid(), SIGKILL); }},
          {"exec", [] { return ::execl("/bin/true", "true", nullptr); }}};
}

// Those that only the filter of system calls refuses.
std::vector<Attempt> moreAttempts(const std::string& victim) {
  return {{"change rights", [=] { return ::chmod(victim.c_str(), 0777); }},
          {"look for a file", [=] { return ::access(victim.c_str(), F_OK); }},
          {"start a process", [] { return ::fork(); }},
          {"debug the parent", [] { return ::ptrace(PTRACE_ATTACH, ::getppid(), 0, 0); }},
          {"change user", [] { return ::setuid(0); }},
          {"executable memory",
           [] {
             void* memory =
                 ::mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
             return memory == MAP_FAILED ? -1L : 0L;
           }},
          {"make memory executable",
           [] {
             void* memory =
                 ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
             return long(::mprotect(memory, 4096, PROT_READ | PROT_EXEC));
           }},
          {"raise a limit", [] {
             const rlimit wide{100, 100};
             return long(::setrlimit(RLIMIT_NOFILE, &wide));
           }}};
}

// The names of the attempts that were not refused, and the environment that is left.
std::string whatGetsThrough(const std::vector<Attempt>& list, const SandboxWalls& walls) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    enterSandbox(ends[1], walls);
    std::string through;
    for (const Attempt& attempt : list)
      if (attempt.act() >= 0) through += attempt.name + "; ";
    if (environ && *environ) through += "environment; ";
    if (std::getenv("PATH")) through += "PATH; ";
    through += "end";
    [[maybe_unused]] const ssize_t sent = ::write(ends[1], through.data(), through.size());
    ::_exit(0);
  }
  ::close(ends[1]);
  std::string text(4096, '\0');
  const ssize_t got = ::read(ends[0], text.data(), text.size());
  text.resize(got > 0 ? std::size_t(got) : 0);
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return text;
}

struct Planted {
  test::TemporaryFolder folder;
  std::string victim = (folder / "victim").string();
  int ends[2];
  Planted() {
    std::ofstream(victim) << "secret";
    REQUIRE(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0);
  }
  ~Planted() {
    ::close(ends[0]);
    ::close(ends[1]);
  }
};

}  // namespace

TEST_CASE("planted code gets through no wall of the sandbox") {
  const Planted planted;
  std::vector<Attempt> list = attempts(planted.victim, planted.ends[0]);
  for (Attempt& more : moreAttempts(planted.victim)) list.push_back(std::move(more));
  CHECK(whatGetsThrough(list, {}) == "end");
  CHECK(test::bytesOf(planted.victim) == "secret");
}

TEST_CASE("without Landlock the filter of system calls holds alone") {
  const Planted planted;
  std::vector<Attempt> list = attempts(planted.victim, planted.ends[0]);
  for (Attempt& more : moreAttempts(planted.victim)) list.push_back(std::move(more));
  CHECK(whatGetsThrough(list, {.landlock = false}) == "end");
  CHECK(test::bytesOf(planted.victim) == "secret");
}

TEST_CASE("without the filter Landlock holds files, network and signals") {
  if (missingWalls().find("Landlock") != std::string::npos) {
    MESSAGE("skipped: this kernel has no Landlock");
    return;
  }
  const Planted planted;
  CHECK(whatGetsThrough(attempts(planted.victim, planted.ends[0]), {.systemCalls = false}) ==
        "end");
  CHECK(test::bytesOf(planted.victim) == "secret");
}

TEST_CASE("the attempts succeed without a sandbox, so that their refusal says something") {
  const Planted planted;
  for (const Attempt& attempt : attempts(planted.victim, planted.ends[0])) {
    if (attempt.name == "kill the parent" || attempt.name == "exec") continue;
    CAPTURE(attempt.name);
    const long result = attempt.act();
    CHECK(result >= 0);
    if (attempt.name == "rename") std::ofstream(planted.victim) << "again";
  }
}

TEST_CASE("what is refused to planted code is refused to every reader") {
  const Planted planted;
  const std::string through = runInChild("x", {}, [&] {
    std::string text;
    for (const Attempt& attempt : attempts(planted.victim, planted.ends[0]))
      if (attempt.act() >= 0) text += attempt.name + "; ";
    return text;
  });
  CHECK(through == "");
  CHECK(test::bytesOf(planted.victim) == "secret");
}
