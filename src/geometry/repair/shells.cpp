#include "geometry/repair/shells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/measures.h"
#include "geometry/repair/crossings.h"
#include "geometry/topology.h"

namespace resect {

std::vector<Shell> shellsOf(const TriangleMesh& mesh) {
  const std::vector<TriangleMesh> bodies = splitComponents(mesh);
  std::vector<Shell> shells;
  std::vector<int> turns, around(bodies.size(), 0);  // of the shell itself; of those round it
  for (const TriangleMesh& body : bodies) {
    const Aabb box = bounds(body);
    const double volume = volumeAbout(body, box.centre());
    shells.push_back({ShellKind::Body, std::abs(volume), box});
    turns.push_back(volume < 0 ? -1 : 1);
  }
  // Several points vote, since one may lie on the other's surface.
  constexpr std::size_t kVotes = 5;
  std::vector<std::size_t> candidates;
  std::vector<Vec3> voters;
  for (std::size_t outer = 0; outer < bodies.size(); ++outer) {
    candidates.clear();
    voters.clear();
    for (std::size_t inner = 0; inner < bodies.size(); ++inner) {
      if (inner == outer || !shells[outer].box.contains(shells[inner].box.min) ||
          !shells[outer].box.contains(shells[inner].box.max))
        continue;
      candidates.push_back(inner);
      const std::vector<Vec3>& points = bodies[inner].points;
      for (std::size_t v = 0; v < kVotes; ++v) voters.push_back(points[v * points.size() / kVotes]);
    }
    std::vector<int> rounds = crossingNumbers(bodies[outer], voters);
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const auto first = rounds.begin() + std::ptrdiff_t(c * kVotes);
      std::nth_element(first, first + kVotes / 2, first + kVotes);
      around[candidates[c]] += first[kVotes / 2];
    }
  }
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const bool tissueOutside = around[i] > 0, tissueInside = around[i] + turns[i] > 0;
    shells[i].kind = tissueInside == tissueOutside ? ShellKind::Within
                     : tissueInside                ? ShellKind::Body
                                                   : ShellKind::Cavity;
  }
  return shells;
}

double tissueVolume(const std::vector<Shell>& shells) {
  double volume = 0;
  for (const Shell& shell : shells) {
    if (shell.kind == ShellKind::Body) volume += shell.volume;
    if (shell.kind == ShellKind::Cavity) volume -= shell.volume;
  }
  return volume;
}

}  // namespace resect
