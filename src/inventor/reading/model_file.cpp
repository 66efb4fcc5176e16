#include "inventor/reading/model_file.h"

#include <Inventor/SoInput.h>

#include "base/error.h"
#include "formats/child/child_process.h"
#include "formats/child/foreign_file.h"
#include "formats/gzip.h"
#include "formats/meshes/gltf_file.h"
#include "formats/meshes/obj_file.h"
#include "formats/meshes/off_file.h"
#include "formats/meshes/ply_file.h"
#include "formats/meshes/stl_file.h"
#include "formats/meshes/vtk_file.h"
#include "formats/meshes/word_reader.h"
#include "formats/model_kind.h"
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

// What Coin is given: text without what may stand before and after it, binary files as they are.
std::string_view inventorText(const std::string& path, std::string_view bytes) {
  const std::string_view text = plainText(path, bytes);
  const bool isBinary = inventorFormat(text).ends_with(" binary");
  return isBinary ? bytes : text;
}

Model readHere(const fs::path& path, std::string_view bytes, const BesideFiles& beside,
               SharedNumber& share) {
  if (bytes.empty()) throw error("{}: is empty; choose a file that holds a surface", path.string());
  std::string unpacked;
  if (isGzip(bytes)) bytes = unpacked = unpackGzip(path.string(), bytes, kLargestUnpacked);
  // A text of any kind may begin with a byte order mark; the header of a binary .stl with anything.
  if (bytes.starts_with(kByteOrderMark) && !isExactBinaryStl(bytes))
    bytes.remove_prefix(kByteOrderMark.size());
  const std::string name = path.string();
  switch (modelKind(path, bytes)) {
    case ModelKind::Inventor:
      return readInventorFile(name, inventorText(name, bytes), ShapeReading::Converted,
                              [&](double now) { share.set(now); });
    case ModelKind::Vtk:
      return readVtkFile(name, bytes);
    case ModelKind::Obj:
      return readObjFile(name, bytes);
    case ModelKind::Stl:
      return readStlFile(name, bytes);
    case ModelKind::Ply:
      return readPlyFile(name, bytes);
    case ModelKind::Off:
      return readOffFile(name, bytes);
    case ModelKind::Glb:
    case ModelKind::Gltf:
      break;
  }
  return readGltfFile(name, bytes, beside);
}

// Whether Coin may be needed, told without unpacking the file: this is asked outside the sandbox.
bool mayBeInventor(const fs::path& path, std::string_view bytes) {
  if (isInventorFile(bytes) || isGzip(bytes)) return true;
  const std::string ending = lowerCase(path.extension().string());
  return ending == ".iv" || ending == ".wrl" || ending == ".gz";
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
          if (mayBeInventor(path, {bytes.data(), bytes.size()})) prepareCoin();
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
