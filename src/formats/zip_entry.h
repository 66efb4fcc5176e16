// Reads one file out of a ZIP archive.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace resect {

// Whether the bytes begin as a ZIP archive does.
bool isZip(std::string_view bytes);

// The content of the first file in the archive whose name ends with `ending`, in any letter case.
// Nothing if there is none. bytes: the whole archive. path: its name, for the message of an Error.
// Throws Error if the archive is damaged or truncated, if the file is compressed otherwise than by
// deflate, or if it unpacks to more than `most` bytes. Archives beyond 4 GB (ZIP64) are refused.
std::optional<std::string> zipEntry(const std::string& path, std::string_view bytes,
                                    std::string_view ending, std::size_t most);

}  // namespace resect
