#include "inventor/reading/model_file.h"

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "base/error.h"
#include "base/large_pages.h"
#include "base/raw_array.h"
#include "formats/assimp_file.h"
#include "formats/child_process.h"
#include "formats/gzip.h"
#include "formats/vtk_file.h"
#include "inventor/reading/iv_guard.h"
#include "inventor/reading/iv_reader.h"
#include "inventor/reading/nurbs_context.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = std::uintmax_t(1) << 30;
constexpr std::size_t kLargestUnpacked = std::size_t(1) << 29;

RawArray<char> allBytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  RawArray<char> bytes;
  const std::size_t size = fs::file_size(path);
  bytes.reserve(size);
  wantLargePages(bytes.data(), size);
  bytes.resize(size);
  in.read(bytes.data(), std::streamsize(bytes.size()));
  if (!in || std::size_t(in.gcount()) != bytes.size())
    throw error("{}: cannot be read: {}; check the disk", path.string(), std::strerror(errno));
  return bytes;
}

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

Model readHere(const fs::path& path, SharedNumber& share) {
  const RawArray<char> stored = allBytes(path);
  std::string_view bytes(stored.data(), stored.size());
  if (bytes.empty()) throw error("{}: is empty; choose a file that holds a surface", path.string());
  std::string unpacked;
  if (isGzip(bytes)) bytes = unpacked = unpackGzip(path.string(), bytes, kLargestUnpacked);
  const fs::path name = formatName(path, bytes);
  const std::string extension = lowerExtension(name);
  if (isInventorFile(bytes) || extension == ".iv" || extension == ".wrl")
    return readInventorFile(path.string(), bytes, ShapeReading::Converted,
                            [&](double now) { share.set(now); });
  if (isVtkFile(bytes) || extension == ".vtk") return readVtkFile(path.string(), bytes);
  if (isAssimpFile(name)) return readAssimpFile(path, name, bytes);
  throw error(
      "{}: is of no kind that can be read; use .iv, .wrl, .obj, .stl, .ply, .off, .glb, .gltf "
      "or .vtk",
      path.string());
}

}  // namespace

Model readModel(const fs::path& path) { return readModelWithin(path, 5); }

Model readModelWatched(const fs::path& path, const Progress& progress) {
  return readModelWithin(path, 5, progress);
}

Model readModelWithin(const fs::path& path, double seconds, const Progress& progress) {
  std::error_code ec;
  const fs::file_status status = fs::status(path, ec);
  if (!fs::exists(status)) throw error("{}: there is no such file; check the name", path.string());
  if (fs::is_directory(status)) throw error("{}: is a folder; name a file in it", path.string());
  if (!fs::is_regular_file(status))
    throw error("{}: is no ordinary file; copy the model into one", path.string());
  const std::uintmax_t size = fs::file_size(path, ec);
  if (ec) throw error("{}: cannot be read: {}; check the name", path.string(), ec.message());
  if (size > kLargestFile)
    throw error("{}: has {} MB, more than the {} MB that are read; simplify the model",
                path.string(), size >> 20, kLargestFile >> 20);
  if (std::ifstream in(path, std::ios::binary); !in)
    throw error("{}: cannot be opened: {}; check who may read it", path.string(),
                std::strerror(errno));
  ChildLimits limits;
  limits.cpuSeconds = seconds + double(size) / (1 << 20);
  limits.wallSeconds = 4 * limits.cpuSeconds;  // allowance for other load on the processor
  SharedNumber share(-1);
  const std::string bytes = runInChild(
      path.string(), limits,
      [&] {
        pretendOffscreenContext();
        const Model model = readHere(path, share);
        checkModel(model);
        return modelToBytes(model);
      },
      [&] { report(progress, share.get()); });
  Model model = bytesToModel(bytes, path.string());
  report(progress, 1);
  return model;
}

}  // namespace resect
