// The header of a .ply file. It says which elements the file has, and which properties the elements
// have.
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
  std::string name;  // converted to lower case
  PlyNumber type = PlyNumber::Float32;
  bool isList = false;
  PlyNumber countType = PlyNumber::Uint8;  // for a list: type of the number of its entries
};

struct PlyElement {
  std::string name;  // converted to lower case
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyForm : std::uint8_t { Text, LittleEndian, BigEndian };

struct PlyHeader {
  PlyForm form = PlyForm::Text;
  std::vector<PlyElement> elements;  // in the order of the file
  std::size_t end = 0;               // offset of the first byte after the header
};

// If the header is damaged or incomplete, throws an Error that names the line. The first line may
// end with LF, CR LF or CR, and all other lines of the header must end in the same way. (Otherwise
// a byte 0A after the header could belong to the line end or to the data.)
PlyHeader readPlyHeader(const std::string& path, std::string_view bytes);

}  // namespace resect
