#include <span>

#include "base/state/saved_state.h"
#include "fuzz_target.h"
#include "support/resealed.h"

namespace {

// With a right digest, which the fuzzer would not find.
void read(std::string_view bytes) {
  const auto input = std::as_bytes(std::span(bytes));
  resect::stateFromBytes(resect::test::resealed({input.begin(), input.end()}));
}

}  // namespace

RESECT_FUZZ_TARGET(read(bytes))
