// Reads one file out of a ZIP archive.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace resect {

// Whether the bytes begin with the signature of a ZIP archive.
bool isZip(std::string_view bytes);

// Searches the archive for a file with a name that ends with `ending`, in upper or lower case.
// Returns the content of the first such file, or nothing if there is none. path: name of the
// archive, for messages. bytes: the whole archive. most: largest number of bytes that the file may
// have after it is unpacked. Throws Error if the file is larger than `most`, or if it is compressed
// by a method other than deflate. Also throws Error if the archive is damaged or truncated, or if
// the archive has the format for more than 4 GB (ZIP64).
std::optional<std::string> zipEntry(const std::string& path, std::string_view bytes,
                                    std::string_view ending, std::size_t most);

}  // namespace resect
