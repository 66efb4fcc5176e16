#include "io/scenario/orientation.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "geometry/rotation.h"

namespace resect {
namespace {

// Where a letter points to in the room; zero if it is no letter of a direction.
Vec3 directionOf(char letter) {
  switch (std::toupper(static_cast<unsigned char>(letter))) {
    case 'L':
      return Vec3::UnitX();
    case 'R':
      return -Vec3::UnitX();
    case 'A':
      return Vec3::UnitY();
    case 'P':
      return -Vec3::UnitY();
    case 'I':
    case 'F':
      return Vec3::UnitZ();
    case 'S':
    case 'H':
      return -Vec3::UnitZ();
    default:
      return Vec3::Zero();
  }
}

}  // namespace

Eigen::Quaterniond orientationOf(const std::string& letters) {
  Mat3 axes = Mat3::Zero();
  if (letters.size() == 3)
    for (int i = 0; i < 3; ++i) axes.col(i) = directionOf(letters[std::size_t(i)]);
  const double volume = axes.determinant();
  if (std::abs(volume) < 0.5)
    throw usageError(
        "--orientation is \"{}\"; give where the model's x, y and z axis point to, as LPS or RAS: "
        "L or R (the patient's left or right), A or P (front or back), S or I (head or feet)",
        letters);
  if (volume < 0)
    throw usageError(
        "--orientation {} is left-handed: no turn makes a model lie so, only a mirror; check the "
        "letters, or export the model with right-handed axes",
        letters);
  return Eigen::Quaterniond(axes).normalized();
}

Eigen::Quaterniond turnOf(const std::string& text) {
  constexpr double kMostDegrees = 3600;
  double degrees[3] = {};
  const char* at = text.data();
  const char* end = at + text.size();
  int count = 0;
  while (count < 3) {
    const auto [rest, ec] = std::from_chars(at, end, degrees[count]);
    if (ec != std::errc() || !(std::abs(degrees[count]) <= kMostDegrees)) break;
    ++count;
    at = rest;
    if (at == end || *at != ',' || count == 3) break;
    ++at;
  }
  if (count != 3 || at != end)
    throw usageError("--rotate is \"{}\"; give degrees about the room's X, Y and Z axis, as 0,90,0",
                     text);
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  for (int a = 0; a < 3; ++a)
    turn = rotationAbout(Vec3::Unit(a), degrees[a] * std::numbers::pi / 180) * turn;
  return turn.normalized();
}

}  // namespace resect
