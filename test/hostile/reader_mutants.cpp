// reader_mutants SEEDS SECONDS [COUNT]: changes the seed files at random and reads each mutant as
// the program does, through readModel(), for SECONDS or until every seed has had COUNT mutants.
//
// What is asked: every mutant gives a model or an Error in one clean sentence, in time; nothing
// else is thrown, and this process lives on. A mutant that breaks this is kept in the folder
// reader_mutants_broken. Readers that crash in their sandbox are counted: that is contained, and no
// fault of the program.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "base/text/shown_text.h"
#include "inventor/reading/model_file.h"
#include "io/whole_file.h"
#include "support/sentence.h"
#include "support/temporary_folder.h"

using namespace resect;
namespace fs = std::filesystem;

namespace {

constexpr double kReaderSeconds = 2;  // of computing; the seeds take milliseconds

struct Seed {
  std::string name, bytes;
  int mutants = 0, read = 0, refused = 0, contained = 0, slow = 0, broken = 0;
};

// Numbers and words at which readers go wrong.
const std::vector<std::string> kOdd{
    "-1",       "0",        "4294967295", "2147483648", "-2147483648",
    "1e308",    "nan",      "-inf",       "1e-320",     "99999999999999999999",
    "{",        "}",        "[",          "]",          "\"",
    "#",        "DEF A ",   "USE A",      "\n",         std::string(1, '\0'),
    "\x1b[31m", "\xff\xfe", "65536",      "-3",         "0x7fffffff"};

std::string mutated(std::string bytes, const std::string& other, Random& random) {
  const auto place = [&](const std::string& of) {
    return std::size_t(random.below(int(of.size()) + 1));
  };
  // Most mutants get one change, so that many are still read.
  const int changes = 1 + (random.below(3) == 0 ? random.below(10) : 0);
  for (int i = 0; i < changes; ++i) {
    if (bytes.empty()) return bytes;
    const std::size_t at = std::min(place(bytes), bytes.size() - 1);
    const std::size_t length =
        std::min(std::size_t(1 + random.below(random.below(3) == 0 ? 200 : 8)), bytes.size() - at);
    switch (random.below(12)) {
      case 0:
        bytes[at] = char(bytes[at] ^ (1 << random.below(8)));
        break;
      case 1:
        bytes[at] = char(random.below(256));
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.substr(std::min(place(bytes), bytes.size() - 1), length));
        break;
      case 4:
        bytes.insert(at, kOdd[std::size_t(random.below(int(kOdd.size())))]);
        break;
      case 5:
        bytes.replace(at, length, kOdd[std::size_t(random.below(int(kOdd.size())))]);
        break;
      case 6:
        bytes.resize(at);
        break;
      case 7:
        bytes.insert(at, other.substr(std::min(place(other), other.size() - 1), length));
        break;
      case 9:
      case 10:
      case 11: {  // another digit of a number in text
        const std::size_t digit = bytes.find_first_of("0123456789", at);
        if (digit != std::string::npos) bytes[digit] = char('0' + random.below(10));
        break;
      }
      case 8: {  // a number in binary, with all bits or none
        const char fill = random.below(2) ? '\xff' : '\0';
        for (std::size_t j = at; j < std::min(at + 4, bytes.size()); ++j) bytes[j] = fill;
        break;
      }
    }
  }
  return bytes;
}

// Empty if the mutant was read or refused as it should be.
std::string faultOf(Seed& seed, const fs::path& file) {
  const auto begin = std::chrono::steady_clock::now();
  std::string fault;
  try {
    readModelWithin(file, kReaderSeconds);
    ++seed.read;
  } catch (const Error& e) {
    const std::string text = shownSentence(e.what());  // as every command and the window show it
    ++seed.refused;
    if (test::tells(text, "the reader stopped on it")) ++seed.contained;
    if (test::tells(text, "so it was given up")) ++seed.slow;
    if (!test::isOneSentence(text) || !text.starts_with(file.string()))
      fault = "no clean sentence: " + text;
    for (const char c : text)
      if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
        fault = "control characters in: " + text;
  } catch (const std::exception& e) {
    fault = std::string("threw ") + e.what();
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (seconds > 5 * kReaderSeconds) fault = "took " + std::to_string(seconds) + " s";
  return fault;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "reader_mutants SEEDS SECONDS [COUNT]\n";
    return 2;
  }
  const double seconds = std::atof(argv[2]);
  const int most = argc > 3 ? std::atoi(argv[3]) : 1 << 30;
  std::vector<Seed> seeds;
  for (const auto& entry : fs::directory_iterator(argv[1]))
    seeds.push_back({entry.path().filename().string(), readWholeFile(entry.path())});
  std::ranges::sort(seeds, {}, &Seed::name);

  const test::TemporaryFolder folder;
  Random random{std::uint64_t(most)};
  int broken = 0;
  const auto begin = std::chrono::steady_clock::now();
  const auto timeLeft = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() <
           seconds;
  };
  for (int round = 0; round < most && timeLeft(); ++round)
    for (Seed& seed : seeds) {
      const Seed& other = seeds[std::size_t(random.below(int(seeds.size())))];
      const std::string bytes = mutated(seed.bytes, other.bytes, random);
      const fs::path file = folder.write(seed.name, bytes);
      ++seed.mutants;
      if (const std::string fault = faultOf(seed, file); !fault.empty()) {
        ++seed.broken, ++broken;
        fs::create_directories("reader_mutants_broken");
        const std::string kept =
            "reader_mutants_broken/" + std::to_string(seed.mutants) + "_" + seed.name;
        fs::copy_file(file, kept, fs::copy_options::overwrite_existing);
        std::cout << kept << ": " << fault << "\n";
      }
    }
  std::printf("%-16s %9s %9s %9s %12s %9s %9s\n", "seed", "mutants", "read", "refused", "contained",
              "given up", "broken");
  for (const Seed& s : seeds)
    std::printf("%-16s %9d %9d %9d %12d %9d %9d\n", s.name.c_str(), s.mutants, s.read, s.refused,
                s.contained, s.slow, s.broken);
  return broken > 0 ? 1 : 0;
}
