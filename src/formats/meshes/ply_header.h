// The header of a .ply file: which elements follow, with which properties.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace resect {

enum class PlyNumber : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t bytesOf(PlyNumber type);  // size of one number of this type

struct PlyProperty {
  std::string name;  // in small letters
  PlyNumber type = PlyNumber::Float32;
  bool isList = false;
  PlyNumber countType = PlyNumber::Uint8;  // type of a list's length
};

struct PlyElement {
  std::string name;  // in small letters
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyForm : std::uint8_t { Text, LittleEndian, BigEndian };

struct PlyHeader {
  PlyForm form = PlyForm::Text;
  std::vector<PlyElement> elements;  // in the order of the file
  std::size_t end = 0;               // offset of the first byte of data
};

// Throws Error, which names the line, if the header is damaged or incomplete. The header's lines
// may end with LF, CR LF or CR, but all must end like the first one. Otherwise it would be unknown
// whether a byte 0A after the header belongs to the data.
PlyHeader readPlyHeader(const std::string& path, std::string_view bytes);

}  // namespace resect
