#include "peers/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <thread>
#include <vector>

namespace resect::bench {
namespace {

std::string timeText(double s) {
  return s < 1e-3 ? fmt::format("{:.3g} us", 1e6 * s)
         : s < 1  ? fmt::format("{:.3g} ms", 1e3 * s)
                  : fmt::format("{:.3g} s", s);
}

std::string ratioText(double r) {
  return r == 0 ? "" : r < 10 ? fmt::format("{:.2f}", r) : fmt::format("{:.0f}", r);
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

}  // namespace

std::string machineName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name"))
      return fmt::format("{}, {} threads", line.substr(line.find(':') + 2),
                         std::thread::hardware_concurrency());
  return fmt::format("{} threads", std::thread::hardware_concurrency());
}

std::string asMarkdown(const Findings& findings) {
  std::vector<std::vector<Comparison>> tables;  // one for each row, work and peer
  for (const Comparison& c : findings.comparisons) {
    auto table = std::ranges::find_if(tables, [&](const auto& lines) {
      const Comparison& o = lines.front();
      return o.row == c.row && o.work == c.work && o.peer == c.peer;
    });
    if (table == tables.end()) table = tables.insert(tables.end(), std::vector<Comparison>{});
    table->push_back(c);
  }
  std::string text;
  for (const std::vector<Comparison>& lines : tables) {
    const Comparison& first = lines.front();
    text += fmt::format(
        "**{}. {}** (peer: {})\n\n"
        "| {} | threads | Resect | peer | times faster | goal | runs | drift |\n"
        "|---|---|---|---|---|---|---|---|\n",
        first.row, first.work, first.peer, first.sizeUnit);
    for (const Comparison& c : lines)
      text += fmt::format("| {:.0f} | {} | {} | {} | {} | {} | {} / {} | {:.2f} |\n", c.size,
                          c.threads, timeText(c.resect), timeText(c.peerTime), ratioText(c.ratio()),
                          ratioText(c.goal), c.resectRuns, c.peerRuns, c.drift);
    text += "\nAnswers compared:\n\n";
    std::string told;  // the same at any number of threads, so once for each size
    for (const Comparison& c : lines) {
      const std::string line = fmt::format("- {:.0f}: {}\n", c.size, c.agreement);
      if (line != told) text += line;
      told = line;
    }
    text += '\n';
  }
  std::string row;
  for (const Figure& f : findings.figures) {
    if (f.row != row)
      text += fmt::format("{}**{}. Our own figures**\n\n| what | figure | goal |\n|---|---|---|\n",
                          row.empty() ? "" : "\n", f.row);
    row = f.row;
    text += fmt::format("| {} | {} | {} |\n", f.what, f.value, f.goal);
  }
  return text;
}

std::string asCsv(const Findings& findings) {
  std::string text =
      "row,work,peer,size,unit,threads,resect_s,peer_s,ratio,goal,resect_runs,peer_runs,drift,"
      "agreement\n";
  for (const Comparison& c : findings.comparisons)
    text += fmt::format("{},{},{},{:.0f},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{},{},{:.4g},{}\n",
                        c.row, quoted(c.work), quoted(c.peer), c.size, c.sizeUnit, c.threads,
                        c.resect, c.peerTime, c.ratio(), c.goal, c.resectRuns, c.peerRuns, c.drift,
                        quoted(c.agreement));
  return text;
}

std::string figuresAsCsv(const Findings& findings) {
  std::string text = "row,what,figure,goal\n";
  for (const Figure& f : findings.figures)
    text += fmt::format("{},{},{},{}\n", f.row, quoted(f.what), quoted(f.value), quoted(f.goal));
  return text;
}

}  // namespace resect::bench
