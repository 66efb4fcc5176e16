#include "sph/lattice_extent.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace resect {
namespace {

struct Axis {
  double first, last;
  int count;
  bool reached(double spacing) const { return first + count * spacing == last; }
  double spacing() const { return (last - first) / count; }
  // By how much the spacing may vary without changing the far corner.
  double slack() const {
    return (std::nextafter(std::abs(last), std::numeric_limits<double>::infinity()) -
            std::abs(last)) /
           count;
  }
};

double rounded(double value, int digits) {
  char text[40];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits - 1).ptr;
  double result = value;
  std::from_chars(text, end, result);
  return result;
}

std::optional<double> commonSpacing(std::span<const Axis> axes) {
  const Axis* sharpest = &axes[0];
  for (const Axis& axis : axes)
    if (axis.slack() < sharpest->slack()) sharpest = &axis;
  const auto fits = [&](double spacing) {
    for (const Axis& axis : axes)
      if (!axis.reached(spacing)) return false;
    return true;
  };
  const double divided = sharpest->spacing();
  for (int digits = 1; digits <= 17; ++digits)
    if (const double spacing = rounded(divided, digits); fits(spacing)) return spacing;
  double below = divided, above = divided;
  for (int ulp = 0; ulp < 8; ++ulp) {
    below = std::nextafter(below, 0.0);
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
    if (fits(below)) return below;
    if (fits(above)) return above;
  }
  return std::nullopt;
}

}  // namespace

Vec3 farCorner(const Lattice& lattice) {
  return lattice.origin + lattice.spacing.cwiseProduct(lattice.dims.cast<double>());
}

Vec3 spacingBetween(const Vec3& first, const Vec3& last, const Vec3i& dims) {
  const Axis axes[3] = {{first.x(), last.x(), dims.x()},
                        {first.y(), last.y(), dims.y()},
                        {first.z(), last.z(), dims.z()}};
  if (const auto spacing = commonSpacing(axes)) return Vec3::Constant(*spacing);
  Vec3 result;
  for (int a = 0; a < 3; ++a)
    result[a] = commonSpacing(std::span(axes).subspan(a, 1)).value_or(axes[a].spacing());
  return result;
}

Lattice settled(Lattice lattice) {
  if ((lattice.dims.array() > 0).all())
    lattice.spacing = spacingBetween(lattice.origin, farCorner(lattice), lattice.dims);
  return lattice;
}

}  // namespace resect
