#include "formats/images/image_text.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "base/error.h"
#include "formats/meshes/word_reader.h"

namespace resect {

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> result;
  constexpr std::string_view kBlanks = " \t\r\n";
  for (std::size_t at = text.find_first_not_of(kBlanks); at < text.size();
       at = text.find_first_not_of(kBlanks, at)) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    result.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return result;
}

Vec3 threeNumbers(const std::string& path, std::string_view text) {
  std::string plain(text);
  std::ranges::replace(plain, ',', ' ');
  const std::vector<std::string> parts = words(plain);
  Vec3 result = Vec3::Constant(NAN);
  for (std::size_t i = 0; i < 3 && parts.size() == 3; ++i)
    result[Eigen::Index(i)] = numberOf(parts[i]).value_or(NAN);
  if (!result.allFinite())
    throw error("{}: '{}' in its header are not three numbers; export it again", path, text);
  return result;
}

namespace {

template <typename T>
void appendAs(std::string& bytes, double value) {
  const T number = T(value);
  char raw[sizeof(T)];
  std::memcpy(raw, &number, sizeof(T));
  bytes.append(raw, sizeof(T));
}

}  // namespace

std::string numbersFromText(const std::string& path, std::string_view text, VoxelType type) {
  std::string bytes;
  WordReader reader(path, text);
  for (std::string_view word = reader.word(); !word.empty(); word = reader.word()) {
    const std::optional<double> value = numberOf(word);
    if (!value || !std::isfinite(*value) || std::abs(*value) > 1e15)
      throw reader.unexpected(word, "the number of a voxel");
    if (type == VoxelType::F32 || type == VoxelType::F64) {
      type == VoxelType::F32 ? appendAs<float>(bytes, *value) : appendAs<double>(bytes, *value);
      continue;
    }
    // Whole numbers of any width are told apart by their bytes from the lowest on.
    std::string whole;
    appendAs<std::int64_t>(whole, *value);
    if (*value != std::floor(*value)) throw notLabels(path, fmt::format("it holds {}", word));
    bytes.append(whole, 0, bytesOf(type));
  }
  return bytes;
}

std::string_view besideVoxels(const std::string& path, const std::string& name,
                              const BesideFiles& beside) {
  if (!isVoxelFile(name))
    throw error(
        "{}: its voxels are in '{}', which is no .raw, .zraw, .img or .gz beside it; save it as "
        "one file",
        path, name);
  const auto found = beside.find(name);
  if (found == beside.end()) throw LacksFile{name};
  return {found->second.data(), found->second.size()};
}

}  // namespace resect
