#include "formats/png_file.h"

#include <png.h>

#include "base/error.h"
#include "io/output/atomic_file.h"
#include "io/output/output_target.h"

namespace resect {

void checkPngFile(const std::filesystem::path& path) {
  const bool file = findTarget(path).kind == OutputTarget::Kind::File;
  if (path.extension() != ".png" && (file || path.has_extension()))
    throw usageError("cannot write a picture as {}; give a name that ends in .png", path.string());
}

std::string pngBytes(const RgbImage& image) {
  require(image.width > 0 && image.height > 0 &&
              image.pixels.size() == std::size_t(3) * image.width * image.height,
          "a picture of {} x {} pixels with {} bytes is none; give three bytes a pixel",
          image.width, image.height, image.pixels.size());
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width;
  header.height = image.height;
  header.format = PNG_FORMAT_RGB;
  header.flags = PNG_IMAGE_FLAG_FAST;

  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(header), '\0');
  png_alloc_size_t size = bytes.size();
  if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr))
    throw error("cannot encode a picture: {}", header.message);
  bytes.resize(size);
  return bytes;
}

void writePng(const std::filesystem::path& path, const RgbImage& image) {
  const std::string bytes = pngBytes(image);
  writeFileAtomically(path, [&](std::ostream& out) { out << bytes; });
}

RgbImage readPng(const std::filesystem::path& path) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&header, path.c_str()))
    throw error("{}: not a readable PNG file: {}", path.string(), header.message);
  header.format = PNG_FORMAT_RGB;
  RgbImage image{int(header.width), int(header.height), {}};
  image.pixels.resize(PNG_IMAGE_SIZE(header));
  const png_color black{0, 0, 0};
  if (!png_image_finish_read(&header, &black, image.pixels.data(), 0, nullptr))
    throw error("{}: the PNG file is damaged: {}", path.string(), header.message);
  return image;
}

}  // namespace resect
