#include "formats/child/foreign_reading.h"

#include "base/error.h"
#include "formats/child/foreign_file.h"

namespace resect {
namespace {

constexpr std::size_t kLargestFile = std::size_t(1) << 30;  // with all that is beside it
constexpr std::size_t kMostBeside = 16;

// The child's answer: what was read, or the name of a file beside it that it lacks.
constexpr char kRead = 'r', kLacks = 'l';

}  // namespace

std::string readForeign(const std::filesystem::path& path, const ForeignReading& how,
                        const std::function<std::string(const ForeignFile&)>& read) {
  const RawArray<char> bytes = readForeignFile(path, kLargestFile);
  const std::string_view view(bytes.data(), bytes.size());
  BesideFiles beside;
  std::size_t size = bytes.size();
  SharedNumber share(-1);
  for (;;) {
    ChildLimits limits;
    limits.cpuSeconds = how.seconds + double(size) / (1 << 20);
    limits.wallSeconds = 4 * limits.cpuSeconds;  // allowance for other load on the processor
    std::string answer = runInChild(
        path.string(), limits,
        [&]() -> std::string {
          try {
            return kRead + read({view, beside, share});
          } catch (const LacksFile& file) {
            return kLacks + file.name;
          }
        },
        [&] { report(how.progress, share.get()); },
        [&] {
          if (how.prepare) how.prepare(view);
        });
    if (answer.starts_with(kRead)) {
      report(how.progress, 1);
      return answer.substr(1);
    }
    const std::string lacking = answer.substr(1);
    if (beside.size() == kMostBeside || beside.contains(lacking))
      throw error("{}: refers to more than {} files; export it as one file", path.string(),
                  kMostBeside);
    // The reader has checked this too; but the sandbox is for a reader that a file has taken over.
    if (!mayReferTo(path, lacking))
      throw error(
          "{}: refers to '{}', which holds neither buffers nor voxels; export it as one file",
          path.string(), lacking);
    RawArray<char> more = readForeignFileBeside(path, lacking, kLargestFile - size);
    size += more.size();
    beside.emplace(lacking, std::move(more));
  }
}

}  // namespace resect
