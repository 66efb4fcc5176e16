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
  std::vector<std::uint8_t> pixels;  // [height * width * 3], red green blue, top row first

  const std::uint8_t* at(int x, int y) const { return &pixels[3 * (std::size_t(y) * width + x)]; }
};

// To be called before long work. Throws Error if the file cannot be written (findTarget() in
// io/output/output_target.h). Throws a usage Error unless the name ends in .png; a device or pipe
// may also have a name without extension.
void checkPngFile(const std::filesystem::path& path);

// A PNG file's bytes, 8 bits per channel, sRGB. Width and height must be positive.
std::string pngBytes(const RgbImage& image);

// Writes 8 bits per channel, sRGB. Width and height must be positive. Throws Error if the file
// cannot be written; a file that existed under that name is then unchanged.
void writePng(const std::filesystem::path& path, const RgbImage& image);

// Reads any PNG as 8-bit RGB; transparent pixels are blended with black. Throws Error if the file
// cannot be read.
RgbImage readPng(const std::filesystem::path& path);

}  // namespace resect
