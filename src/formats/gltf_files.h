// Finds the buffer files beside .gltf models.
#pragma once

#include <filesystem>
#include <vector>

namespace resect {

// Both functions look only at the name's extension, in upper or lower case. Buffers have the
// extension .bin, .glbin or .glbuf (glTF 2.0, "Implementation Note").
bool isGltf(const std::filesystem::path& name);
bool isGltfBuffer(const std::filesystem::path& name);

// For each .gltf file in `files`, appends all buffers in its folder, since its reader may be given
// any of them. Which of them the model uses is not known here, since only the reader in its sandbox
// parses models.
void addFilesOfGltf(std::vector<std::filesystem::path>& files);

}  // namespace resect
