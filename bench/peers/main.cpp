// Resect beside other people's libraries, in one process: how many times faster, and does it give
// the same answers? Uses those that were found when it was built.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/kept_memory.h"
#include "io/output/atomic_file.h"
#include "peers/rows.h"
#include "peers/tables.h"

using namespace resect;
using namespace resect::bench;

namespace {

struct Row {
  const char* name;
  const char* package;  // that brings the peer; empty: none is needed
  Findings (*measure)(const Effort&);
};

#ifndef RESECT_PEER_VTK
constexpr auto rebuildAgainstVtk = nullptr, updateAgainstVtk = nullptr,
               samplingAgainstVtk = nullptr;
#endif
#ifndef RESECT_PEER_OPENVDB
constexpr auto rebuildAgainstOpenVdb = nullptr;
#endif
#ifndef RESECT_PEER_EMBREE
constexpr auto samplingAgainstEmbree = nullptr;
#endif
#ifndef RESECT_PEER_FCL
constexpr auto contactsAgainstFcl = nullptr;
#endif

const Row kRows[] = {
    {"A", "libvtk9-dev", rebuildAgainstVtk},
    {"B", "libopenvdb-dev", rebuildAgainstOpenVdb},
    {"C", "libvtk9-dev", updateAgainstVtk},
    {"E", "libvtk9-dev", samplingAgainstVtk},
    {"E", "libembree-dev", samplingAgainstEmbree},
    {"F", "libfcl-dev", contactsAgainstFcl},
    {"G", "", loadingAgainstCoin},
    {"H", "", memoryOfStillOrgan},
    {"I", "", millionParticlesInRealTime},
};

// 1 where an answer differs from a peer's.
int reportDisagreements(const Findings& findings) {
  int status = 0;
  for (const Comparison& c : findings.comparisons)
    if (!c.agrees) {
      fmt::print(stderr, "resect_peers: error: row {}, {} {}: the answers do not agree: {}\n",
                 c.row, c.size, c.sizeUnit, c.agreement);
      status = 1;
    }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  keepFreedMemory();
  CLI::App app("Times Resect beside VTK, OpenVDB, Embree, FCL and Coin in one process",
               "resect_peers");
  Effort effort;
  std::vector<std::string> wanted;
  std::string folder;
  app.add_option("--row", wanted, "Only these rows: A B C E F G H I")->delimiter(',');
  app.add_flag("--quick", effort.quick, "Small sizes only");
  app.add_option("--runs", effort.runs, "Runs of each")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--patience", effort.patience,
                 "Seconds that a peer's runs of one line may take together; it runs at least once")
      ->capture_default_str();
  app.add_option("--output", folder,
                 "Folder for peers.md, peers.csv, peers_figures.csv and peers.svg");
  CLI11_PARSE(app, argc, argv);
  try {
    fmt::print("{}\n", machineName());
    Findings all;
    for (const Row& row : kRows) {
      if (!wanted.empty() && std::ranges::find(wanted, row.name) == wanted.end()) continue;
      if (!row.measure) {
        fmt::print("{}: left out; {} was not there when this was built\n", row.name, row.package);
        continue;
      }
      const Findings found = row.measure(effort);
      fmt::print("\n{}", asMarkdown(found));
      std::fflush(stdout);
      all.comparisons.insert(all.comparisons.end(), found.comparisons.begin(),
                             found.comparisons.end());
      all.figures.insert(all.figures.end(), found.figures.begin(), found.figures.end());
    }
    const int status = reportDisagreements(all);
    if (folder.empty()) return status;
    const std::filesystem::path to = folder;
    writeFileAtomically(to / "peers.md", [&](std::ostream& out) {
      out << machineName() + "\n\n" + asMarkdown(all);
    });
    writeFileAtomically(to / "peers.csv", [&](std::ostream& out) { out << asCsv(all); });
    writeFileAtomically(to / "peers_figures.csv",
                        [&](std::ostream& out) { out << figuresAsCsv(all); });
    writeFileAtomically(to / "peers.svg", [&](std::ostream& out) { out << asSvg(all); });
    fmt::print("\nwritten: peers.md, peers.csv, peers_figures.csv and peers.svg in {}\n", folder);
    return status;
  } catch (const Error& e) {
    fmt::print(stderr, "resect_peers: error: {}\n", e.what());
    return int(e.status());
  }
}
