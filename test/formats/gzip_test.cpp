#include "formats/gzip.h"

#include <doctest/doctest.h>
#include <zlib.h>

#include "base/error.h"
#include "base/random.h"

using namespace resect;

namespace {

std::string gzipped(const std::string& text) {
  z_stream stream{};
  REQUIRE(deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = uInt(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = uInt(bytes.size());
  REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

std::string randomBytes(std::size_t size) {
  Random random(1);
  std::string text(size, '\0');
  for (char& c : text) c = char(random.below(256));
  return text;
}

}  // namespace

TEST_CASE("what was packed is unpacked, in one member or several") {
  for (const std::string& text :
       {std::string(), std::string("a"), std::string(5'000'000, 'z'), randomBytes(3'000'000)}) {
    const std::string bytes = gzipped(text);
    CHECK(isGzip(bytes));
    CHECK(unpackGzip("f", bytes, 10'000'000) == text);
    CHECK(unpackGzip("f", bytes + gzipped("tail"), 10'000'000) == text + "tail");
    CHECK(unpackGzip("f", bytes + std::string(100, '\0'), 10'000'000) == text);
  }
  CHECK_FALSE(isGzip("plain"));
}

TEST_CASE("damaged, cut off and bursting data are refused") {
  const std::string bytes = gzipped(randomBytes(100'000));
  for (std::size_t length = 2; length < bytes.size(); length += 9973)
    CHECK_THROWS_AS(unpackGzip("f", bytes.substr(0, length), 1 << 20), Error);
  std::string damaged = bytes;
  damaged[bytes.size() / 2] ^= 0x10;
  CHECK_THROWS_AS(unpackGzip("f", damaged, 1 << 20), Error);
  CHECK_THROWS_WITH_AS(unpackGzip("f", gzipped(std::string(2 << 20, 'z')), 1 << 20),
                       "f: unpacks to more than 1 MB; simplify the model", Error);
}
