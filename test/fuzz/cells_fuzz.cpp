#include <fmt/format.h>

#include "base/crc32.h"
#include "fuzz_target.h"
#include "io/cells/cells_file.h"

namespace {

// With a right checksum, which the fuzzer would not find. The input ends before the checksum's
// line.
void read(std::string_view bytes) {
  const std::string sealed = fmt::format("{}\ncrc32 {:08x}\n", bytes, resect::crc32(bytes));
  resect::parseCells(sealed, "input.resect-cells");
}

}  // namespace

RESECT_FUZZ_TARGET(read(bytes))
