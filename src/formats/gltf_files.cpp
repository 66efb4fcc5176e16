#include "formats/gltf_files.h"

#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace resect {
namespace {

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = char(std::tolower(static_cast<unsigned char>(c)));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

// "my%20file.bin" to "my file.bin".
std::string decoded(const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
    const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
    if (low >= 0) i += 2;
    name += low >= 0 ? char(16 * high + low) : uri[i];
  }
  return name;
}

std::vector<std::filesystem::path> filesOf(const std::filesystem::path& model) {
  std::string extension = model.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  std::vector<std::filesystem::path> files;
  std::error_code ec;
  if (extension != ".gltf" || !std::filesystem::is_regular_file(model, ec)) return files;
  std::ifstream in(model, std::ios::binary);
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object()) return files;
  for (const char* list : {"buffers", "images"}) {
    const auto found = json.find(list);
    if (found == json.end() || !found->is_array()) continue;
    for (const auto& one : *found) {
      const auto uri = one.is_object() ? one.find("uri") : one.end();
      if (uri == one.end() || !uri->is_string()) continue;
      const std::string text = uri->get<std::string>();
      if (!text.starts_with("data:")) files.push_back(model.parent_path() / decoded(text));
    }
  }
  return files;
}

}  // namespace

void addFilesOfGltf(std::vector<std::filesystem::path>& files) {
  for (std::size_t i = 0, models = files.size(); i < models; ++i)
    for (const std::filesystem::path& one : filesOf(files[i])) files.push_back(one);
}

}  // namespace resect
