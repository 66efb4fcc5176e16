// The files beside .gltf models that belong to them.
#pragma once

#include <filesystem>
#include <vector>

namespace resect {

// Appends the buffers and pictures to which .gltf files among `files` refer (glTF 2.0, 3.6.1.1),
// whether they exist or not. Models of other formats are one file; what cannot be read as JSON
// refers to none.
void addFilesOfGltf(std::vector<std::filesystem::path>& files);

}  // namespace resect
