// The name of a file without folder and endings. It serves as the name of what the file contains,
// such as a scenario or a label.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// The file's name without its folder and without any of its endings, such as "liver" for
// "/scans/liver.nii.gz". If the name begins with a dot, this dot is not the start of an ending.
inline std::string fileStem(std::string_view path) {
  const std::string_view name = path.substr(path.find_last_of('/') + 1);
  return std::string(name.substr(0, name.find('.', 1)));
}

}  // namespace resect
