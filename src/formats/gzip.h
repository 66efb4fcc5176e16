// Decompresses gzip files.
#pragma once

#include <string>
#include <string_view>

namespace resect {

bool isGzip(std::string_view bytes);

// Unpacks all members of the file (RFC 1952). Throws Error about `path` if the data are damaged or
// truncated, or are more than `most` bytes when unpacked.
std::string unpackGzip(const std::string& path, std::string_view bytes, std::size_t most);

}  // namespace resect
