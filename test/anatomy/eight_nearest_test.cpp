// The eight nearest places.
#include "anatomy/eight_nearest.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"

using namespace resect;

TEST_CASE("the eight nearest places are those of a search through all") {
  Random random(7);
  const auto point = [&](double size) {
    return Vec3(size * random.uniform(), size * random.uniform(), size * random.uniform());
  };
  for (const int count : {1, 7, 8, 300}) {
    std::vector<Vec3> places;
    for (int i = 0; i < count; ++i) places.push_back(point(0.2));
    const EightNearest nearest(places);
    for (int i = 0; i < 500; ++i) {
      const Vec3 p = point(0.3) - Vec3::Constant(0.05);  // some lie outside
      std::vector<double> all;
      for (const Vec3& place : places) all.push_back((place - p).squaredNorm());
      std::ranges::sort(all);
      const auto found = nearest(p);
      for (std::size_t k = 0; k < 8; ++k)
        if (k < all.size()) {
          CHECK(found[k].squaredDistance == all[k]);
          CHECK((places[std::size_t(found[k].place)] - p).squaredNorm() == all[k]);
        } else {
          CHECK(std::isinf(found[k].squaredDistance));
        }
    }
  }
}
