#include "organ/discretize.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "collision/columns.h"
#include "sph/lattice_extent.h"

namespace resect {
namespace {

constexpr int kSamples = 4;  // per axis of a cell

// Throws when there are too many cells; `counts` may be beyond int.
Lattice makeLattice(const Vec3& origin, const Vec3& spacing, const Vec3& counts) {
  if (!(counts.prod() <= double(kMaxCells)))
    throw error("a spacing of {:.3g} m needs {:.3g} cells, more than {}; choose a larger spacing",
                spacing.minCoeff(), counts.prod(), kMaxCells);
  return settled({origin, spacing, counts.cast<int>()});
}

// Cells needed to cover `extent`; an excess within rounding gets no further cell.
Vec3 cellsOver(const Vec3& extent, double spacing) {
  return (extent / spacing - Vec3::Constant(1e-9)).array().ceil().cwiseMax(1);
}

}  // namespace

Lattice latticeForSpacing(const Aabb& box, double spacing) {
  if (!(spacing > 0) || !std::isfinite(spacing))
    throw usageError("the spacing must be a length above zero, not {} m", spacing);
  if (box.empty()) throw error("there is no lattice over an empty mesh; give one with triangles");
  return makeLattice(box.min + Vec3::Constant(0.5 * spacing), Vec3::Constant(spacing),
                     cellsOver(box.size(), spacing));
}

Lattice latticeForDims(const Aabb& box, const Vec3i& dims) {
  if ((dims.array() < 1).any())
    throw usageError("the grid needs at least one cell per axis, not {} x {} x {}", dims.x(),
                     dims.y(), dims.z());
  if (box.empty() || (box.size().array() <= 0).any())
    throw error("there is no grid over a flat or empty mesh; give a closed body");
  return makeLattice(box.min, box.size().cwiseQuotient(dims.cast<double>()),
                     dims.cast<double>() + Vec3::Ones());
}

Lattice cubicLatticeForDims(const Aabb& box, int dims) {
  if (dims < 1) throw usageError("the grid needs at least one cell per axis, not {}", dims);
  if (box.empty() || !(box.size().maxCoeff() > 0))
    throw error("there is no grid over an empty mesh; give a closed body");
  const double spacing = box.size().maxCoeff() / dims;
  return makeLattice(box.min, Vec3::Constant(spacing),
                     cellsOver(box.size() + Vec3::Constant(0.5 * spacing), spacing));
}

Discretization discretize(const TriangleMesh& mesh, const Lattice& lattice,
                          const Progress& progress) {
  require(lattice.sound(), "the lattice's cells are {} x {} x {} m; give finite lengths above 0",
          lattice.spacing.x(), lattice.spacing.y(), lattice.spacing.z());
  require(lattice.cellCount() <= kMaxCells,
          "the lattice has {} cells, more than {}; choose a larger spacing", lattice.cellCount(),
          kMaxCells);
  const int nx = lattice.dims.x(), ny = lattice.dims.y(), nz = lattice.dims.z();
  Discretization result;
  result.lattice = lattice;
  RawArray<std::uint8_t> levels(std::size_t(lattice.cellCount()), 0);
  result.inside.assign(lattice.cellCount(), 0);
  if (lattice.cellCount() == 0) return result;

  report(progress, 0);
  const SnappedMesh snapped = snapToRaster(mesh);
  const Vec2 origin = lattice.origin.head<2>(), spacing = lattice.spacing.head<2>();
  const Crossings centres = castColumns(snapped, ColumnGrid{origin, spacing, nx, ny});
  const SampleLine along{lattice.origin.z(), lattice.spacing.z(), nz};
  report(progress, 0.1);
  // The samples lie at (k + 1/2) / 4 of the cell.
  const double shift = 0.5 / kSamples - 0.5;
  const Crossings fine = castColumns(
      snapped,
      ColumnGrid{origin + shift * spacing, spacing / kSamples, kSamples * nx, kSamples * ny});
  const SampleLine alongFine{lattice.origin.z() + shift * lattice.spacing.z(),
                             lattice.spacing.z() / kSamples, kSamples * nz};
  report(progress, 0.5);

  const auto fillRow = [&](int j, std::vector<std::uint8_t>& filled,
                           std::vector<std::uint8_t>& inside) {
    // One row of cells, z fastest: samples inside (0..64) and the centre's flag.
    filled.assign(std::size_t(nx) * nz, 0);
    inside.assign(std::size_t(nx) * nz, 0);
    for (int i = 0; i < nx; ++i) {
      std::uint8_t* const column = filled.data() + std::size_t(i) * nz;
      for (int sub = 0; sub < kSamples * kSamples; ++sub) {
        const int x = kSamples * i + sub % kSamples, y = kSamples * j + sub / kSamples;
        forEachInside(fine[std::size_t(y) * std::size_t(kSamples * nx) + std::size_t(x)], alongFine,
                      [&](int begin, int end) {
                        for (int k = begin / kSamples; k * kSamples < end; ++k)
                          column[k] +=
                              std::min(end, (k + 1) * kSamples) - std::max(begin, k * kSamples);
                      });
      }
      forEachInside(centres[std::size_t(j) * std::size_t(nx) + std::size_t(i)], along,
                    [&](int begin, int end) {
                      for (int k = begin; k < end; ++k) {
                        inside[std::size_t(i) * nz + k] = 1;
                        column[k] = std::max<std::uint8_t>(column[k], 1);
                      }
                    });
    }
    constexpr int kPerSample = kFullLevel / (kSamples * kSamples * kSamples);
    static_assert(kPerSample * kSamples * kSamples * kSamples == kFullLevel);
    for (int k = 0; k < nz; ++k) {
      const std::int64_t first = lattice.index({0, j, k});
      for (int i = 0; i < nx; ++i) {
        levels[first + i] = std::uint8_t(kPerSample * filled[std::size_t(i) * nz + k]);
        result.inside[first + i] = inside[std::size_t(i) * nz + k];
      }
    }
  };

  constexpr int kReports = 16;
  for (int part = 0; part < kReports; ++part) {
    const int firstRow = int(std::int64_t(ny) * part / kReports);
    const int lastRow = int(std::int64_t(ny) * (part + 1) / kReports);
    parallelFor(lastRow - firstRow, 2, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint8_t> filled, inside;
      for (std::size_t row = begin; row < end; ++row) fillRow(firstRow + int(row), filled, inside);
    });
    report(progress, 0.5 + 0.5 * (part + 1) / kReports);
  }
  result.value = ColourValues(std::move(levels));
  return result;
}

}  // namespace resect
