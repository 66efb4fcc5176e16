#include "formats/meshes/gltf_requirements.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "base/text/shown_text.h"
#include "formats/meshes/word_reader.h"

namespace resect {
namespace {

using Json = nlohmann::json;

constexpr int kFloat = 5126;  // glTF's number for this type

void putWord(std::string& bytes, std::uint64_t value) {
  for (int i = 0; i < 4; ++i) bytes += char(value >> (8 * i));
}

// The library reads beyond the end of a truncated binary glTF file, so its structure is checked
// here (glTF 2.0, 4.4): a header of 12 bytes with the total length, then chunks with their lengths.
void checkFrame(const std::string& path, std::string_view bytes) {
  const auto number = [&](std::size_t at) { return std::uint64_t(littleEndian(bytes, at)); };
  const auto cutOff = [&] {
    return error("{}: is shorter than it says itself; copy or export it again", path);
  };
  if (bytes.size() < 12) throw cutOff();
  if (number(4) != 2) throw error("{}: is glTF version {}; export it as glTF 2.0", path, number(4));
  const std::uint64_t length = number(8);
  if (length > bytes.size()) throw cutOff();
  if (length < 20) throw error("{}: has no JSON; export it again", path);
  for (std::uint64_t at = 12; at < length; at += 8 + number(at))
    if (at + 8 > length || number(at) > length - at - 8) throw cutOff();
}

bool changesLooksOnly(const std::string& extension) {
  constexpr std::array kLooks{"KHR_materials_", "KHR_texture_", "KHR_lights_",   "KHR_xmp",
                              "EXT_texture_",   "EXT_lights_",  "MSFT_texture_", "KHR_animation_"};
  return std::ranges::any_of(kLooks, [&](const char* look) { return extension.starts_with(look); });
}

void checkRequired(const std::string& path, const Json& json) {
  for (const Json& one : json.value("extensionsRequired", Json::array())) {
    const std::string extension = one.get<std::string>();
    if (extension == "KHR_mesh_quantization" || changesLooksOnly(extension)) continue;
    const bool packed = extension.ends_with("_compression");
    throw error("{}: requires the glTF extension {}, which is not read; export it without{}", path,
                shownText(extension, 60), packed ? " compression" : "");
  }
}

// RFC 4648; ends at the first character that belongs to no data.
std::string fromBase64(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t held = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == kDigits.npos) break;
    held = held << 6 | std::uint32_t(digit);
    if ((bits += 6) >= 8) bytes += char(held >> (bits -= 8));
  }
  return bytes;
}

struct NumberType {
  std::size_t bytes = 0;
  bool isSigned = false;
};
NumberType numberType(int component) {
  if (component == 5120) return {1, true};
  if (component == 5121) return {1, false};
  if (component == 5122) return {2, true};
  if (component == 5123) return {2, false};
  return {};
}

class Dequantizer {
 public:
  Dequantizer(const std::string& path, Json json, std::string_view chunk, const BesideFiles& beside)
      : path_(path), json_(std::move(json)), chunk_(chunk), beside_(beside) {}

  // Whether there was anything to do.
  bool apply() {
    for (Json& mesh : json_.value("meshes", Json::array()))
      for (Json& primitive : mesh.value("primitives", Json::array()))
        if (isQuantized(primitive)) accessors_.insert(positionsOf(primitive));
    if (accessors_.empty()) return false;
    const std::size_t buffer = json_.at("buffers").size();
    for (const std::size_t accessor : accessors_) rewrite(accessor, buffer);
    json_["buffers"].push_back({{"uri", kPlainPositions}, {"byteLength", positions_.size()}});
    for (Json& mesh : json_["meshes"])
      for (Json& primitive : mesh["primitives"]) keepPositionsOnly(primitive);
    if (json_.contains("extensionsRequired"))
      std::erase_if(json_["extensionsRequired"].get_ref<Json::array_t&>(),
                    [](const Json& name) { return name == "KHR_mesh_quantization"; });
    return true;
  }
  const Json& json() const { return json_; }
  std::string takePositions() { return std::move(positions_); }

 private:
  static std::size_t positionsOf(const Json& primitive) {
    return primitive.at("attributes").at("POSITION").get<std::size_t>();
  }
  bool isQuantized(const Json& primitive) const {
    const Json attributes = primitive.value("attributes", Json::object());
    if (!attributes.contains("POSITION")) return false;
    if (primitive.value("extensions", Json::object()).contains("KHR_draco_mesh_compression"))
      return false;
    return json_.at("accessors").at(positionsOf(primitive)).at("componentType") != kFloat;
  }
  // Normals and the like may be quantized too.
  void keepPositionsOnly(Json& primitive) const {
    if (!primitive.contains("attributes") || !primitive["attributes"].contains("POSITION")) return;
    if (!accessors_.contains(positionsOf(primitive))) return;
    primitive["attributes"] = {{"POSITION", positionsOf(primitive)}};
    primitive.erase("targets");
  }

  void rewrite(std::size_t number, std::size_t newBuffer) {
    Json& accessor = json_["accessors"].at(number);
    const NumberType type = numberType(accessor.at("componentType").get<int>());
    if (type.bytes == 0 || accessor.at("type") != "VEC3" || accessor.contains("sparse"))
      throw error("{}: has quantized positions of an unknown form; export it without {}", path_,
                  "KHR_mesh_quantization");
    const Json& view = json_["bufferViews"].at(accessor.at("bufferView").get<std::size_t>());
    const std::string_view buffer = bufferOf(view.at("buffer").get<std::size_t>());
    const auto count = accessor.at("count").get<std::uint64_t>();
    const auto stride = view.value("byteStride", std::uint64_t(3 * type.bytes));
    const auto start =
        view.value("byteOffset", std::uint64_t(0)) + accessor.value("byteOffset", std::uint64_t(0));
    if (start > buffer.size() || stride < 3 * type.bytes ||
        count > (buffer.size() - start + stride - 3 * type.bytes) / stride)
      throw error("{}: its positions lie beyond the end of their buffer; export it again", path_);
    const bool normalized = accessor.value("normalized", false);
    const std::size_t begin = positions_.size();
    for (std::uint64_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        putWord(positions_,
                std::bit_cast<std::uint32_t>(
                    value(buffer.substr(start + i * stride + k * type.bytes), type, normalized)));
    json_["bufferViews"].push_back(
        {{"buffer", newBuffer}, {"byteOffset", begin}, {"byteLength", positions_.size() - begin}});
    json_["accessors"].at(number) = {{"bufferView", json_["bufferViews"].size() - 1},
                                     {"componentType", kFloat},
                                     {"count", count},
                                     {"type", "VEC3"}};
  }

  // glTF 2.0, 3.6.2.2: normalized numbers are shares of the largest, and not below -1.
  static float value(std::string_view bytes, NumberType type, bool normalized) {
    int raw = static_cast<unsigned char>(bytes[0]);
    if (type.bytes == 2) raw |= static_cast<unsigned char>(bytes[1]) << 8;
    const int range = 1 << (8 * type.bytes);
    if (type.isSigned && raw >= range / 2) raw -= range;
    if (!normalized) return float(raw);
    return std::max(float(raw) / float(type.isSigned ? range / 2 - 1 : range - 1), -1.f);
  }

  std::string_view bufferOf(std::size_t number) {
    const Json& buffer = json_["buffers"].at(number);
    if (!buffer.contains("uri")) return chunk_;
    const std::string uri = buffer["uri"].get<std::string>();
    if (const std::size_t comma = uri.find(','); uri.starts_with("data:") && comma != uri.npos)
      return decoded_.emplace(number, fromBase64(std::string_view(uri).substr(comma + 1)))
          .first->second;
    const std::string name = withoutPercents(uri);
    const auto file = beside_.find(name);
    if (file == beside_.end()) {
      requireGltfBuffer(path_, name);
      throw LacksFile{name};
    }
    return {file->second.data(), file->second.size()};
  }

  const std::string& path_;
  Json json_;
  std::string_view chunk_;  // the binary part of a .glb
  const BesideFiles& beside_;
  std::set<std::size_t> accessors_;             // of quantized positions
  std::map<std::size_t, std::string> decoded_;  // buffers
  std::string positions_;
};

// The same file with another JSON.
std::string withJson(std::string_view file, bool isBinary, std::string_view chunks,
                     const std::string& json) {
  if (!isBinary) return json;
  std::string text = json;
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string bytes(file.substr(0, 8));
  putWord(bytes, 20 + text.size() + chunks.size());
  putWord(bytes, text.size());
  bytes += "JSON";
  bytes += text;
  bytes += chunks;
  return bytes;
}

}  // namespace

PlainGltf plainGltf(const std::string& path, std::string_view bytes, const BesideFiles& beside) {
  const bool isBinary = bytes.starts_with("glTF");
  std::string_view text = bytes, chunks;  // the JSON; what follows it
  if (isBinary) {
    checkFrame(path, bytes);
    const std::size_t jsonEnd = 20 + littleEndian(bytes, 12);
    text = bytes.substr(20, jsonEnd - 20);
    chunks = bytes.substr(jsonEnd, littleEndian(bytes, 8) - jsonEnd);
  }
  text = plainText(path, text);
  try {
    Json json = Json::parse(text);
    checkRequired(path, json);
    Dequantizer dequantizer(path, std::move(json), chunks.size() > 8 ? chunks.substr(8) : "",
                            beside);
    if (!dequantizer.apply()) return {};
    return {withJson(bytes, isBinary, chunks, dequantizer.json().dump()),
            dequantizer.takePositions()};
  } catch (const Json::parse_error& e) {
    const bool torn = e.byte > text.size();
    throw error("{}: {}; copy or export it again", path,
                torn ? std::string("the file ends early: its JSON is cut off")
                     : fmt::format("its JSON is damaged at byte {}", e.byte));
  } catch (const Json::exception&) {
    throw error("{}: its JSON is not that of a glTF 2.0 file; export it again", path);
  }
}

}  // namespace resect
