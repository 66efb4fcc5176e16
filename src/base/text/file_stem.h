// The name that a file gives to what is in it.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// The file's name without folder and without all of its endings, such as "liver" for
// "/scans/liver.nii.gz". A dot at the beginning of the name begins no ending.
inline std::string fileStem(std::string_view path) {
  const std::string_view name = path.substr(path.find_last_of('/') + 1);
  return std::string(name.substr(0, name.find('.', 1)));
}

}  // namespace resect
