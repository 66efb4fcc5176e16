// The files beside .gltf models that may belong to them.
#pragma once

#include <filesystem>
#include <vector>

namespace resect {

// By the name's ending, in upper or lower case. A buffer: .bin, .glbin or .glbuf (glTF 2.0,
// "Implementation Note").
bool isGltf(const std::filesystem::path& name);
bool isGltfBuffer(const std::filesystem::path& name);

// For each .gltf among `files`, appends the buffers of its folder: those that its reader may be
// given. Which of them the model names is not looked up, since only the reader in its sandbox
// parses a model.
void addFilesOfGltf(std::vector<std::filesystem::path>& files);

}  // namespace resect
