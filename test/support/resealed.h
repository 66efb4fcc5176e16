// A saved state that somebody changed and whose digest they made anew: what only a reader that
// checks every number refuses.
#pragma once

#include <cstring>

#include "base/state/run_length.h"
#include "base/state/state_hash.h"

namespace resect::test {

// The last eight bytes are a digest of those before.
inline Bytes resealed(Bytes state) {
  if (state.size() < 8) return state;
  StateHash hash;
  hash.addBytes(state.data(), state.size() - 8);
  const std::uint64_t digest = hash.value();
  std::memcpy(state.data() + state.size() - 8, &digest, 8);
  return state;
}

}  // namespace resect::test
