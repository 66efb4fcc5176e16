// Buffer files beside .gltf models.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace resect {

// Both functions look only at the name's extension, in upper or lower case. Buffers have the
// extension .bin, .glbin or .glbuf (glTF 2.0, "Implementation Note").
bool isGltf(const std::filesystem::path& name);
bool isGltfBuffer(const std::filesystem::path& name);

// Decodes percent codes: "my%20buffer.bin" becomes "my buffer.bin" (RFC 3986, 2.1).
std::string withoutPercents(std::string_view text);

// Throws Error, about the model at `path`, unless isGltfBuffer(name).
void requireGltfBuffer(const std::string& path, const std::string& name);

}  // namespace resect
