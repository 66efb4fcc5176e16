// Buffer files beside .gltf models.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace resect {

// Both functions look only at the extension of the name, which may be in upper or lower case.
// Buffer files have the extension .bin, .glbin or .glbuf (glTF 2.0, "Implementation Note").
bool isGltf(const std::filesystem::path& name);
bool isGltfBuffer(const std::filesystem::path& name);

// The text with its percent codes decoded (RFC 3986, section 2.1): "my%20buffer.bin" becomes "my
// buffer.bin".
std::string withoutPercents(std::string_view text);

// Throws an Error about the model at `path` unless isGltfBuffer(name) is true.
void requireGltfBuffer(const std::string& path, const std::string& name);

}  // namespace resect
