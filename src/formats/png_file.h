// Writes and reads PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace resect {

struct RgbImage {
  int width = 0;                     // pixels
  int height = 0;                    // pixels
  std::vector<std::uint8_t> pixels;  // [height * width * 3]: red, green, blue; top row first

  const std::uint8_t* at(int x, int y) const { return &pixels[3 * (std::size_t(y) * width + x)]; }
};

// Call this before long work whose result will be written to the file. Throws Error if the file
// cannot be written (findTarget() in io/output/output_target.h). The name must end in .png; the
// name of a device or a pipe may also have no extension. For any other name, throws a usage Error.
void checkPngFile(const std::filesystem::path& path);

// The bytes of a PNG file that shows the image. The file has 8 bits per channel and is sRGB. Width
// and height of the image must be positive.
std::string pngBytes(const RgbImage& image);

// Writes the image as a PNG file with 8 bits per channel, sRGB. Width and height of the image must
// be positive. Throws Error if the file cannot be written. In that case a file that already has
// this name stays as it was.
void writePng(const std::filesystem::path& path, const RgbImage& image);

// Reads a PNG file of any kind, and converts it to RGB with 8 bits per channel. Transparent pixels
// are blended with black. Throws Error if the file cannot be read.
RgbImage readPng(const std::filesystem::path& path);

}  // namespace resect
