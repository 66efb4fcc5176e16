#include "base/crc32.h"

#include <doctest/doctest.h>

// The check value that every description of CRC-32 gives.
TEST_CASE("the checksum of 123456789 is that of the standard") {
  CHECK(resect::crc32("123456789") == 0xcbf43926u);
  CHECK(resect::crc32("") == 0);
}
