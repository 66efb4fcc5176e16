#include "formats/child/child_process.h"

#include <doctest/doctest.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "support/temporary_folder.h"

using namespace resect;

namespace {

std::string sentenceOfChild(const std::function<std::string()>& work, ChildLimits limits = {}) {
  try {
    runInChild("model.iv", limits, work);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("what the child returns comes back byte by byte") {
  std::string bytes;
  for (int i = 0; i < 300'000; ++i) bytes += char(i * 7);
  CHECK(runInChild("x", {}, [&] { return bytes; }) == bytes);
  CHECK(runInChild("x", {}, [] { return std::string(); }).empty());
}

TEST_CASE("an Error of the child is the parent's Error, with its status") {
  CHECK(sentenceOfChild([]() -> std::string { throw error("model.iv:3: bad; mend it"); }) ==
        "model.iv:3: bad; mend it");
  try {
    runInChild("x", {}, []() -> std::string { throw usageError("wrong"); });
    FAIL("no error");
  } catch (const Error& e) {
    CHECK(e.status() == Error::Status::Usage);
  }
}

TEST_CASE("other exceptions become a sentence about the file") {
  const std::string text =
      sentenceOfChild([]() -> std::string { throw std::runtime_error("odd"); });
  CHECK(text.find("model.iv: ") == 0);
  CHECK(text.find("odd") != std::string::npos);
  CHECK(sentenceOfChild([]() -> std::string { throw 5; }).find("model.iv: ") == 0);
}

TEST_CASE("a child that is killed gives one sentence") {
  const std::string text = sentenceOfChild([]() -> std::string {
    ::raise(SIGSEGV);
    return "";
  });
  CHECK(text.find("model.iv: the reader stopped on it") == 0);
  CHECK(text.find('\n') == std::string::npos);
}

TEST_CASE("a child that leaves without a word gives one sentence") {
  const std::string text = sentenceOfChild([]() -> std::string { ::_exit(0); });
  CHECK(text.find("model.iv: the reader stopped on it") == 0);
}

TEST_CASE("a child that computes for ever is stopped by its share of computing") {
  ChildLimits limits;
  limits.cpuSeconds = 1;
  limits.wallSeconds = 60;
  const std::string text = sentenceOfChild(
      []() -> std::string {
        for (std::atomic<int> i = 0;; ++i) {
        }
      },
      limits);
  CHECK(text.find("more than 1 s of computing") != std::string::npos);
}

TEST_CASE("a child that sleeps is stopped by the clock") {
  ChildLimits limits;
  limits.wallSeconds = 0.2;
  const std::string text = sentenceOfChild(
      []() -> std::string {
        std::this_thread::sleep_for(std::chrono::hours(1));
        return "";
      },
      limits);
  CHECK(text.find("more than 0.2 s") != std::string::npos);
}

TEST_CASE("a child that answers with more than is taken is stopped, with what to do") {
  ChildLimits limits;
  limits.answerBytes = std::size_t(1) << 20;
  limits.ifTooLarge = "take another";
  const auto answer = [](std::size_t bytes) { return [=] { return std::string(bytes, 'x'); }; };
  CHECK(sentenceOfChild(answer(limits.answerBytes), limits) == "");
  const std::string text = sentenceOfChild(answer(8 * limits.answerBytes), limits);
  CHECK(text.find("larger than the 1 MB that are taken; take another") != std::string::npos);
}

#ifndef RESECT_SANITIZED
TEST_CASE("a child that wants more memory than it may is told so") {
  ChildLimits limits;
  limits.memoryBytes = std::size_t(64) << 20;
  const std::string text = sentenceOfChild(
      [] {
        std::vector<std::string> blocks;
        for (;;) blocks.emplace_back(std::size_t(8) << 20, 'x');
        return std::string();
      },
      limits);
  CHECK(text.find("more than 64 MB of memory") != std::string::npos);
}
#endif

TEST_CASE("a child cannot write files") {
  const test::TemporaryFolder folder;
  const auto path = folder / "written";
  CHECK(runInChild("x", {}, [&] {
          std::ofstream out(path);
          out << "some text" << std::flush;
          return std::string(out ? "written" : "refused");
        }) == "refused");
  CHECK(test::bytesOf(path).empty());
}

TEST_CASE("children start while worker threads live, one after the other") {
  std::atomic<int> sum = 0;
  parallelFor(1000, 1, [&](std::size_t begin, std::size_t end) { sum += int(end - begin); });
  CHECK(sum == 1000);
  for (int i = 0; i < 20; ++i)
    CHECK(runInChild("x", {}, [&] { return std::to_string(i); }) == std::to_string(i));
}

TEST_CASE("a number crosses while the child works, and who watches can end it") {
  SharedNumber share(-1), seen(-1);
  const std::string bytes = runInChild(
      "x", {},
      [&] {
        for (const double now : {0.25, 0.5, 1.0}) {
          share.set(now);
          while (seen.get() != now) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return std::string("done");
      },
      [&] { seen.set(share.get()); });
  CHECK(bytes == "done");

  const auto start = std::chrono::steady_clock::now();
  CHECK_THROWS_AS(runInChild(
                      "x", {},
                      [] {
                        std::this_thread::sleep_for(std::chrono::seconds(60));
                        return std::string();
                      },
                      [] { throw Cancelled{}; }),
                  Cancelled);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(30));
}

TEST_CASE("a child that a person ends is cancelled, not damaged") {
  // Who watches knows of it only after the child has ended.
  SharedNumber child(0);
  CHECK_THROWS_AS(runInChild(
                      "x", {},
                      [&]() -> std::string {
                        child.set(::getpid());
                        ::raise(SIGINT);
                        return "";
                      },
                      [&] {
                        const auto id = pid_t(child.get());
                        if (id > 0 && ::kill(id, 0) != 0) throw Cancelled{};
                      }),
                  Cancelled);
}

TEST_CASE(
    "a child that dies in the middle of its answer has said nothing, whoever counts the dead") {
  const std::string answer(std::size_t(64) << 20, 'r');
  const auto dies = [&] {
    SharedNumber child(0);
    std::string text;
    try {
      runInChild(
          "model.iv", {},
          [&] {
            child.set(::getpid());
            return answer;
          },
          [&] {
            // Nobody reads now: the pipe fills.
            while (child.get() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            ::kill(pid_t(child.get()), SIGKILL);
          });
    } catch (const Error& e) {
      text = e.what();
    }
    return text;
  };
  CHECK(dies().find("model.iv: ") == 0);
  const auto before = ::signal(SIGCHLD, SIG_IGN);  // the system forgets how children ended
  CHECK(dies().find("model.iv: ") == 0);
  CHECK(runInChild("x", {}, [] { return std::string("whole"); }) == "whole");
  ::signal(SIGCHLD, before);
}
