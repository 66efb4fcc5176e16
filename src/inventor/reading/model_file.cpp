#include "inventor/reading/model_file.h"

#include <Inventor/SoInput.h>

#include <cctype>

#include "base/error.h"
#include "formats/assimp_file.h"
#include "formats/child/child_process.h"
#include "formats/child/foreign_file.h"
#include "formats/gzip.h"
#include "formats/vtk_file.h"
#include "inventor/init.h"
#include "inventor/reading/iv_guard.h"
#include "inventor/reading/iv_reader.h"
#include "inventor/reading/nurbs_context.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = std::size_t(1) << 30;  // with all that is beside it
constexpr std::size_t kLargestUnpacked = std::size_t(1) << 29;
constexpr std::size_t kMostBeside = 16;

std::string lowerExtension(const fs::path& path) {
  std::string text = path.extension().string();
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// A name with the format's extension: without .gz, and corrected by the first bytes.
fs::path formatName(const fs::path& path, std::string_view bytes) {
  fs::path name = lowerExtension(path) == ".gz" ? path.stem() : path;
  if (bytes.starts_with("glTF")) return name.replace_extension(".glb");
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r"))
    return name.replace_extension(".ply");
  return name;
}

Model readHere(const fs::path& path, std::string_view bytes, const BesideFiles& beside,
               SharedNumber& share) {
  if (bytes.empty()) throw error("{}: is empty; choose a file that holds a surface", path.string());
  std::string unpacked;
  if (isGzip(bytes)) bytes = unpacked = unpackGzip(path.string(), bytes, kLargestUnpacked);
  const fs::path name = formatName(path, bytes);
  const std::string extension = lowerExtension(name);
  if (isInventorFile(bytes) || extension == ".iv" || extension == ".wrl")
    return readInventorFile(path.string(), bytes, ShapeReading::Converted,
                            [&](double now) { share.set(now); });
  if (isVtkFile(bytes) || extension == ".vtk") return readVtkFile(path.string(), bytes);
  if (isAssimpFile(name)) return readAssimpFile(path, name, bytes, beside);
  throw error(
      "{}: is of no kind that can be read; use .iv, .wrl, .obj, .stl, .ply, .off, .glb, .gltf "
      "or .vtk",
      path.string());
}

// The child's answer: a model, or the name of a file beside it that it lacks.
constexpr char kModel = 'm', kLacks = 'l';

std::string answerOf(const fs::path& path, std::string_view bytes, const BesideFiles& beside,
                     SharedNumber& share) {
  try {
    const Model model = readHere(path, bytes, beside, share);
    checkModel(model);
    return kModel + modelToBytes(model);
  } catch (const LacksFile& file) {
    return kLacks + file.name;
  }
}

// What Coin would do at first use, when there are no files any more.
void prepareCoin() {
  prepareNurbs();
  initInventor();
  const SoInput duplicatesStandardInput;  // and tries again at every number if that failed
}

}  // namespace

Model readModel(const fs::path& path) { return readModelWithin(path, 5); }

Model readModelWatched(const fs::path& path, const Progress& progress) {
  return readModelWithin(path, 5, progress);
}

Model readModelWithin(const fs::path& path, double seconds, const Progress& progress) {
  const RawArray<char> bytes = readForeignFile(path, kLargestFile);
  BesideFiles beside;
  std::size_t size = bytes.size();
  SharedNumber share(-1);
  for (;;) {
    ChildLimits limits;
    limits.cpuSeconds = seconds + double(size) / (1 << 20);
    limits.wallSeconds = 4 * limits.cpuSeconds;  // allowance for other load on the processor
    const std::string answer = runInChild(
        path.string(), limits,
        [&] {
          return answerOf(path, {bytes.data(), bytes.size()}, beside, share);
        },
        [&] { report(progress, share.get()); },
        [&] {
          if (!isAssimpFile(formatName(path, {bytes.data(), bytes.size()}))) prepareCoin();
        });
    if (answer.starts_with(kModel)) {
      Model model = bytesToModel(std::string_view(answer).substr(1), path.string());
      report(progress, 1);
      return model;
    }
    const std::string lacking = answer.substr(1);
    if (beside.size() == kMostBeside || beside.contains(lacking))
      throw error("{}: refers to more than {} files; export it as one file", path.string(),
                  kMostBeside);
    RawArray<char> more = readForeignFileBeside(path, lacking, kLargestFile - size);
    size += more.size();
    beside.emplace(lacking, std::move(more));
  }
}

}  // namespace resect
