// A liver that is held at one end sags alike, however it lies in the lattice and whatever the size
// of its cells.
#include <doctest/doctest.h>

#include "geometry/measures.h"
#include "organ/builtin/builtin_liver.h"
#include "organ/discretize.h"
#include "organ/fit_surface.h"
#include "organ/operated_organ.h"
#include "organ/tissue_cells.h"
#include "support/figures.h"
#include "support/references/relax.h"
#include "support/tissue_blocks.h"

using namespace resect;

namespace {

// Mean sag, m, of the last 3 cm of the built-in liver, which is held over 6 cm at the other end.
double sag(double spacing, const Vec3& shift, double capsule) {
  const TriangleMesh mesh = builtinLiver(0.004);
  const Aabb box = bounds(mesh);
  Lattice lattice = latticeForSpacing(box.padded(spacing), spacing);
  lattice.origin += spacing * shift;
  Discretization cells = discretize(mesh, lattice);
  fitSurface(mesh, cells);
  TissueMaterial material = test::plainLiver();
  material.capsule = capsule;
  TissueSettings settings;
  settings.threads = 0;
  auto made = std::make_unique<ElasticTissue>(tissueCells(cells, material), settings);
  ElasticTissue& tissue = *made;
  TissueAttachment held;
  held.kind = TissueAttachment::Kind::Pin;
  held.shape = Region::Shape::Box;
  Vec3 far = box.max;
  far.x() = box.min.x() + 0.06;
  held.box = {box.min, far};
  REQUIRE(tissue.attach(held) > 0);
  const OperatedOrgan organ =
      operatedOrgan("liver", makeOrgan(std::move(cells), {}), std::move(made));
  CHECK(test::relax(tissue, 1e-5) < 40000);
  double sum = 0;
  int count = 0;
  test::forEachCell(tissue, [&](std::int64_t c, const Vec3i& at) {
    if (tissue.lattice().centre(at).x() < box.max.x() - 0.03) return;
    sum -= tissue.displacement(c).y();
    ++count;
  });
  return sum / count;
}

}  // namespace

TEST_CASE("a liver that is held at one end sags alike, however it lies in the lattice") {
  test::Figures figures("sagging liver");
  for (const double capsule : {0.0, 624.0}) {
    const std::string name = capsule > 0 ? "with a capsule" : "without a capsule";
    const auto sagAt = [&](double spacing, double shift) {
      return sag(spacing, Vec3::Constant(shift), capsule);
    };
    const double coarse = sagAt(0.008, 0), shifted = sagAt(0.008, 0.5);
    CHECK(figures.add(name + ": cells of 8 mm shifted by a half, against not shifted (m)", shifted,
                      coarse, 0.05) < 0.05);
    const double fine = 0.5 * (sagAt(0.004, 0) + sagAt(0.004, 0.5));
    MESSAGE(name << ": 8 mm " << coarse << ", shifted " << shifted << ", 4 mm " << fine);
    CHECK(figures.add(name + ": cells of 8 mm against 4 mm (m)", 0.5 * (coarse + shifted), fine,
                      0.1) < 0.1);
  }
}
