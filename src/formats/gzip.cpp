#include "formats/gzip.h"

#include <zlib.h>

#include "base/error.h"

namespace resect {

namespace {

// window: as inflateInit2() takes it, which tells gzip, zlib and raw deflate apart.
std::string unpack(const std::string& path, std::string_view bytes, std::size_t most, int window) {
  z_stream stream{};
  if (inflateInit2(&stream, window) != Z_OK)
    throw error("{}: no memory to unpack it; close other programs", path);
  struct End {
    z_stream& stream;
    ~End() { inflateEnd(&stream); }
  } end{stream};
  // Input in pieces, since zlib counts in 32 bits.
  constexpr std::size_t kPiece = 1 << 20;
  std::string result, block(1 << 18, '\0');
  std::size_t at = 0;
  int status = Z_OK;
  while (at < bytes.size() || stream.avail_in > 0) {
    if (stream.avail_in == 0) {
      const std::size_t size = std::min(kPiece, bytes.size() - at);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + at));
      stream.avail_in = uInt(size);
      at += size;
    }
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = uInt(block.size());
    status = inflate(&stream, Z_NO_FLUSH);
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
      throw error("{}: its compressed data are damaged; copy the file again", path);
    result.append(block, 0, block.size() - stream.avail_out);
    if (result.size() > most)
      throw error("{}: unpacks to more than {} MB; simplify the model", path, most >> 20);
    if (status == Z_STREAM_END && (stream.avail_in > 0 || at < bytes.size())) {
      // Another member may follow; other data after the end is padding.
      const bool more =
          stream.avail_in >= 2 && stream.next_in[0] == 0x1f && stream.next_in[1] == 0x8b;
      if (!more) break;
      inflateReset(&stream);
    }
  }
  // Output that zlib still holds after the last input.
  while (status == Z_OK && stream.avail_out == 0) {
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = uInt(block.size());
    status = inflate(&stream, Z_NO_FLUSH);
    result.append(block, 0, block.size() - stream.avail_out);
    if (result.size() > most)
      throw error("{}: unpacks to more than {} MB; simplify the model", path, most >> 20);
  }
  if (status != Z_STREAM_END)
    throw error("{}: its compressed data are cut off; copy the file again", path);
  return result;
}

constexpr int kWindow = 15, kGzip = 16;

}  // namespace

bool isGzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string unpackGzip(const std::string& path, std::string_view bytes, std::size_t most) {
  return unpack(path, bytes, most, kWindow + kGzip);
}

std::string unpackZlib(const std::string& path, std::string_view bytes, std::size_t most) {
  return unpack(path, bytes, most, kWindow);
}

std::string unpackDeflate(const std::string& path, std::string_view bytes, std::size_t most) {
  return unpack(path, bytes, most, -kWindow);
}

}  // namespace resect
