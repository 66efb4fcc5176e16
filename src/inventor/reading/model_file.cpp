#include "inventor/reading/model_file.h"

#include <Inventor/SoInput.h>

#include "base/error.h"
#include "formats/child/foreign_reading.h"
#include "formats/gzip.h"
#include "formats/images/dicom_file.h"
#include "formats/labels/label_file.h"
#include "formats/labels/label_model.h"
#include "formats/meshes/gltf_file.h"
#include "formats/meshes/obj_file.h"
#include "formats/meshes/off_file.h"
#include "formats/meshes/ply_file.h"
#include "formats/meshes/stl_file.h"
#include "formats/meshes/three_mf_file.h"
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

constexpr std::size_t kLargestUnpacked = kMostImageBytes;

// What Coin is given: text without what may stand before and after it, binary files as they are.
std::string_view inventorText(const std::string& path, std::string_view bytes) {
  const std::string_view text = plainText(path, bytes);
  const bool isBinary = inventorFormat(text).ends_with(" binary");
  return isBinary ? bytes : text;
}

Model readHere(const fs::path& path, const ForeignFile& file, const std::string& parts) {
  std::string_view bytes = file.bytes;
  if (bytes.empty()) throw error("{}: is empty; choose a file that holds a surface", path.string());
  std::string unpacked;
  if (isGzip(bytes)) bytes = unpacked = unpackGzip(path.string(), bytes, kLargestUnpacked);
  // A text of any kind may begin with a byte order mark; the header of a binary .stl with anything.
  if (bytes.starts_with(kByteOrderMark) && !isExactBinaryStl(bytes))
    bytes.remove_prefix(kByteOrderMark.size());
  const std::string name = path.string();
  const ModelKind kind = modelKind(path, bytes);
  const auto progress = [&](double now) { file.share.set(now); };
  if (isImage(kind))
    return labelModel(name, readLabelImage(kind, name, bytes, file.beside), parts, [&](double now) {
      progress(now);
      return true;
    });
  switch (kind) {
    case ModelKind::Inventor:
      return readInventorFile(name, inventorText(name, bytes), ShapeReading::Converted, progress);
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
    case ModelKind::ThreeMf:
      return readThreeMfFile(name, bytes);
    default:
      return readGltfFile(name, bytes, file.beside);
  }
}

// Whether Coin may be needed, told without unpacking the file: this is asked outside the sandbox.
bool mayBeInventor(const fs::path& path, std::string_view bytes) {
  if (isInventorFile(bytes) || isGzip(bytes)) return true;
  const std::string ending = lowerCase(path.extension().string());
  return ending == ".iv" || ending == ".wrl" || ending == ".gz";
}

// What Coin would do at first use, when there are no files any more.
void prepareCoin() {
  prepareNurbs();
  initInventor();
  const SoInput duplicatesStandardInput;  // and tries again at every number if that failed
}

}  // namespace

Model readModel(const fs::path& path, const std::string& parts) {
  return readModelWithin(path, 5, {}, parts);
}

Model readModelWatched(const fs::path& path, const Progress& progress, const std::string& parts) {
  return readModelWithin(path, 5, progress, parts);
}

Model readModelWithin(const fs::path& path, double seconds, const Progress& progress,
                      const std::string& parts) {
  ForeignReading how;
  how.seconds = isImageFile(path) ? std::max(seconds, kImageSeconds) : seconds;
  how.progress = progress;
  how.prepare = [&](std::string_view bytes) {
    if (mayBeInventor(path, bytes)) prepareCoin();
    if (startsAsDicom(bytes)) prepareDicom();
  };
  const std::string answer = readForeign(path, how, [&](const ForeignFile& file) {
    const Model model = readHere(path, file, parts);
    checkModel(model);
    return modelToBytes(model);
  });
  return bytesToModel(answer, path.string());
}

}  // namespace resect
