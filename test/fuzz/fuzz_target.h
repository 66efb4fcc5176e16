// What every fuzz target asks of its reader: a result or one clean sentence, nothing else.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "base/error.h"

namespace resect::test {

// Aborts, which the fuzzer reports with its input, if the reader throws anything but an Error with
// a whole sentence.
template <typename Read>
int fuzz(const std::uint8_t* data, std::size_t size, Read read) {
  try {
    read(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const Error& e) {
    const std::string_view text = e.what();
    if (text.size() < 20) {
      std::fprintf(stderr, "no whole sentence: %s\n", e.what());
      std::abort();
    }
  }
  return 0;
}

}  // namespace resect::test

// Defines the fuzz target: `bytes`, a std::string_view, is the input.
#define RESECT_FUZZ_TARGET(read)                                                      \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) { \
    return resect::test::fuzz(data, size, [](std::string_view bytes) { read; });      \
  }
