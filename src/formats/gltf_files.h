// The files beside .gltf models that may belong to them.
#pragma once

#include <filesystem>
#include <vector>

namespace resect {

// For each .gltf among `files`, appends the files of its folder that its reader may be given: those
// whose names end in .bin, .glbin or .glbuf. Which of them the model names is not looked up, since
// only the reader in its sandbox parses a model.
void addFilesOfGltf(std::vector<std::filesystem::path>& files);

}  // namespace resect
