// What was in a gzip-compressed file?
#pragma once

#include <string>
#include <string_view>

namespace resect {

bool isGzip(std::string_view bytes);

// All members of the file (RFC 1952) unpacked. An Error about `path` when the data are damaged, cut
// off, or longer than `most` bytes unpacked.
std::string unpackGzip(const std::string& path, std::string_view bytes, std::size_t most);

}  // namespace resect
