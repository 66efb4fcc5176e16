#include "formats/meshes/ply_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "formats/meshes/word_reader.h"

namespace resect {
namespace {

struct TypeName {
  std::string_view name;
  PlyNumber type;
};
constexpr std::array<TypeName, 16> kTypes{{{"char", PlyNumber::Int8},
                                           {"int8", PlyNumber::Int8},
                                           {"uchar", PlyNumber::Uint8},
                                           {"uint8", PlyNumber::Uint8},
                                           {"short", PlyNumber::Int16},
                                           {"int16", PlyNumber::Int16},
                                           {"ushort", PlyNumber::Uint16},
                                           {"uint16", PlyNumber::Uint16},
                                           {"int", PlyNumber::Int32},
                                           {"int32", PlyNumber::Int32},
                                           {"uint", PlyNumber::Uint32},
                                           {"uint32", PlyNumber::Uint32},
                                           {"float", PlyNumber::Float32},
                                           {"float32", PlyNumber::Float32},
                                           {"double", PlyNumber::Float64},
                                           {"float64", PlyNumber::Float64}}};

class HeaderReader {
 public:
  HeaderReader(const std::string& path, std::string_view bytes) : path_(path), bytes_(bytes) {
    const std::size_t end = bytes.find_first_of("\r\n");
    if (end != bytes.npos)
      lineEnd_ = bytes.substr(end).starts_with("\r\n") ? "\r\n" : bytes.substr(end, 1);
  }

  PlyHeader read() {
    nextLine();
    if (take() != "ply") throw fail("does not begin with 'ply'");
    bool haveForm = false;
    for (;;) {
      nextLine();
      const std::string word = take();
      if (word == "end_header") break;
      if (word.empty() || word == "comment" || word == "obj_info") continue;
      if (word == "format") {
        header_.form = form(), haveForm = true;
      } else if (word == "element") {
        addElement();
      } else if (word == "property") {
        if (header_.elements.empty()) throw fail("has a property before any element");
        addProperty(header_.elements.back());
      } else {
        throw fail("has '{}' in its header", shownText(word, 30));
      }
    }
    if (!haveForm) throw fail("names no format");
    header_.end = at_;
    return std::move(header_);
  }

 private:
  template <typename... Args>
  Error fail(fmt::format_string<Args...> format, Args&&... args) const {
    return error("{}:{}: {}; export the file again", path_, lines_,
                 fmt::format(format, std::forward<Args>(args)...));
  }

  void nextLine() {
    const std::size_t end = lineEnd_.empty() ? bytes_.npos : bytes_.find(lineEnd_, at_);
    if (end == bytes_.npos) throw fail("the file ends within its header");
    line_ = bytes_.substr(at_, end - at_);
    at_ = end + lineEnd_.size();
    ++lines_;
  }
  // The next word of the line in small letters; empty at its end.
  std::string take() {
    const std::size_t begin = std::min(line_.find_first_not_of(" \t\r"), line_.size());
    const std::size_t end = std::min(line_.find_first_of(" \t\r", begin), line_.size());
    const std::string word = lowerCase(line_.substr(begin, end - begin));
    line_.remove_prefix(end);
    return word;
  }

  PlyForm form() {
    const std::string word = take();
    if (word == "ascii") return PlyForm::Text;
    if (word == "binary_little_endian") return PlyForm::LittleEndian;
    if (word == "binary_big_endian") return PlyForm::BigEndian;
    throw fail("has the unknown format '{}'", shownText(word, 30));
  }

  void addElement() {
    const std::string name = take(), number = take();
    const std::optional<std::int64_t> count = wholeNumberOf(number);
    if (!count || *count < 0)
      throw fail("has '{}' where the number of elements '{}' should be", shownText(number, 30),
                 shownText(name, 30));
    // Each takes a byte at least.
    if (std::uint64_t(*count) > bytes_.size())
      throw fail("the file ends early: its header promises {} elements '{}'", *count,
                 shownText(name, 30));
    header_.elements.push_back({name, *count, {}});
  }

  void addProperty(PlyElement& element) {
    PlyProperty property;
    std::string word = take();
    if (word == "list") {
      property.isList = true;
      property.countType = type(take());
      word = take();
    }
    property.type = type(word);
    property.name = take();
    element.properties.push_back(std::move(property));
  }

  PlyNumber type(const std::string& word) const {
    for (const TypeName& one : kTypes)
      if (one.name == word) return one.type;
    throw fail("has numbers of the unknown type '{}'", shownText(word, 30));
  }

  const std::string& path_;
  std::string_view bytes_, lineEnd_, line_;
  std::size_t at_ = 0;
  int lines_ = 0;
  PlyHeader header_;
};

}  // namespace

std::size_t bytesOf(PlyNumber type) {
  constexpr std::array<std::size_t, 8> kBytes{1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[std::size_t(type)];
}

PlyHeader readPlyHeader(const std::string& path, std::string_view bytes) {
  return HeaderReader(path, bytes).read();
}

}  // namespace resect
