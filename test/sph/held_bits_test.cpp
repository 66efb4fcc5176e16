// Occupancy masks of boxes agree with a cell by cell evaluation.
#include "sph/held_bits.h"

#include <doctest/doctest.h>

#include <vector>

#include "base/random.h"

using namespace resect;

TEST_CASE("what boxes hold, 64 cells at a time, is what their cells hold one by one") {
  Random random(3);
  for (const std::size_t cells : {5u, 64u, 65u, 200u, 300u}) {
    constexpr int kPerPlane = 5, kPlanes = 4;
    HeldBits held(kPerPlane * kPlanes, cells);
    std::fill(held.bits.begin(), held.bits.end(), 0);
    std::vector<int> kind(kPerPlane * kPlanes * cells);  // 0: nothing, 1: something, 2: all
    for (std::size_t row = 0; row < kPerPlane * kPlanes; ++row)
      for (std::size_t x = 0; x < cells; ++x) {
        // Long stretches alike, and some cells of every kind.
        int& here = kind[row * cells + x];
        here = x > 0 && random.below(8) != 0 ? kind[row * cells + x - 1] : int(random.below(3));
        const auto bit = std::uint64_t(1) << x % 64;
        if (here > 0) held.bits[row * held.row + x / 64] |= bit;
        if (here == 2) held.bits[row * held.row + held.words + x / 64] |= bit;
      }
    for (int round = 0; round < 50; ++round) {
      const int width = 1 + int(random.below(9)), rows = 1 + int(random.below(kPerPlane)),
                planes = 1 + int(random.below(kPlanes));
      const std::size_t first = random.below(std::uint64_t(kPlanes - planes + 1)) * kPerPlane +
                                random.below(std::uint64_t(kPerPlane - rows + 1));
      std::vector<std::uint64_t> bits(held.row);
      holdTogether(held, first, rows, planes, kPerPlane, width, bits.data());
      int wrong = 0;
      for (std::size_t x = 0; x + std::size_t(width) <= cells; ++x) {
        bool any = false, lacking = false;
        for (int z = 0; z < planes; ++z)
          for (int y = 0; y < rows; ++y)
            for (int k = 0; k < width; ++k) {
              const int cell =
                  kind[(first + std::size_t(z * kPerPlane + y)) * cells + x + std::size_t(k)];
              any = any || cell > 0;
              lacking = lacking || cell < 2;
            }
        wrong += (bits[x / 64] >> x % 64 & 1) != any;
        wrong += (bits[held.words + x / 64] >> x % 64 & 1) != lacking;
      }
      CHECK(wrong == 0);
    }
  }
}
