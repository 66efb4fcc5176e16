// Decompresses gzip files, zlib streams and raw deflate streams.
#pragma once

#include <string>
#include <string_view>

namespace resect {

// Whether the bytes begin like a gzip file.
bool isGzip(std::string_view bytes);

// Unpacks all members of a gzip file (RFC 1952). bytes: the whole file. path: the file's name, for
// the message of an Error. Throws Error if the data are damaged, truncated, or more than `most`
// bytes when unpacked.
std::string unpackGzip(const std::string& path, std::string_view bytes, std::size_t most);
// The same for a zlib stream (RFC 1950).
std::string unpackZlib(const std::string& path, std::string_view bytes, std::size_t most);
// The same for a raw deflate stream (RFC 1951), as in ZIP archives.
std::string unpackDeflate(const std::string& path, std::string_view bytes, std::size_t most);

}  // namespace resect
