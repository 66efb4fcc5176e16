// VTK's SPH interpolator gives the same colour field.
//
// vtkSPHQuarticKernel is the corrected quartic of sph/kernel.h: 1 / (20 pi h^3) times the fourth
// powers, cut off at 2.5 h. Its Shepard sum over particles of volume mass / density is equation 3.4
// of the thesis; with the mass of a cell weighted by its colour value it is the colour field.

#include <doctest/doctest.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSPHInterpolator.h>
#include <vtkSPHQuarticKernel.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>
#include <cmath>

#include "anatomy/visible_human.h"
#include "organ/discretize.h"
#include "sph/colour_field.h"
#include "sph/kernel.h"
#include "support/block_organ.h"

using namespace resect;

namespace {

vtkNew<vtkPolyData> pointSet(const std::vector<Vec3>& positions) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& p : positions) points->InsertNextPoint(p.data());
  vtkNew<vtkPolyData> set;
  set->SetPoints(points);
  return set;
}

// The colour field over 100 at `nodes`, by VTK.
std::vector<double> shepardSums(const Discretization& cells, const std::vector<Vec3>& nodes) {
  std::vector<Vec3> positions;
  vtkNew<vtkDoubleArray> mass, density;
  mass->SetName("mass");
  density->SetName("density");
  for (std::int64_t i = 0; i < cells.lattice.cellCount(); ++i)
    if (cells.value[i] > 0) {
      positions.push_back(cells.lattice.centre(cells.lattice.cell(i)));
      mass->InsertNextValue(cells.lattice.cellVolume() * 1060 * cells.value[i] / 100);
      density->InsertNextValue(1060);
    }
  const auto source = pointSet(positions), input = pointSet(nodes);
  source->GetPointData()->AddArray(mass);
  source->GetPointData()->AddArray(density);

  vtkNew<vtkSPHQuarticKernel> quartic;
  quartic->SetSpatialStep(kSmoothingPerSpacing * cells.lattice.spacing.x());
  vtkNew<vtkStaticPointLocator> locator;
  vtkNew<vtkSPHInterpolator> interpolator;
  interpolator->SetInputData(input);
  interpolator->SetSourceData(source);
  interpolator->SetKernel(quartic);
  interpolator->SetLocator(locator);
  interpolator->SetMassArrayName("mass");
  interpolator->SetDensityArrayName("density");
  interpolator->ComputeShepardSumOn();
  interpolator->Update();
  vtkDataArray* sums = interpolator->GetOutput()->GetPointData()->GetArray(
      interpolator->GetShepardSumArrayName().c_str());
  std::vector<double> result;
  for (vtkIdType i = 0; i < sums->GetNumberOfTuples(); ++i) result.push_back(sums->GetTuple1(i));
  return result;
}

void compare(const std::string& name, const Discretization& cells) {
  const ColourField field(cells, 2);
  std::vector<Vec3> nodes;
  std::vector<double> ours;
  for (std::int64_t b = 0; b < field.brickCount(); ++b) {
    if (field.slot(b) < 0) continue;
    for (int i = 0; i < kBrickSize; ++i) {
      if (field.values(field.slot(b))[i] == 0) continue;  // VTK leaves points out of reach unset
      const Vec3i node = kBrickNodes * field.brick(b) + Vec3i(i & 3, i >> 2 & 3, i >> 4);
      nodes.push_back(field.nodePosition(node.cast<double>()));
      ours.push_back(field.values(field.slot(b))[i] / 100);
    }
  }
  const std::vector<double> theirs = shepardSums(cells, nodes);
  REQUIRE(theirs.size() == ours.size());
  double worst = 0;
  for (std::size_t i = 0; i < ours.size(); ++i)
    worst = std::max(worst, std::abs(ours[i] - theirs[i]));
  CHECK(worst < 1e-4);
  MESSAGE(name << ": " << ours.size() << " nodes, largest difference " << worst);
}

}  // namespace

TEST_CASE("VTK's quartic kernel is the corrected one") {
  const double h = 0.004;
  vtkNew<vtkSPHQuarticKernel> quartic;
  quartic->SetSpatialStep(h);
  const auto points = pointSet({{0, 0, 0}, {h, 0, 0}});
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(points);
  locator->BuildLocator();
  quartic->Initialize(locator, points, points->GetPointData());
  CHECK(quartic->GetCutoffFactor() == kKernelSupport);
  for (int i = 0; i <= 300; ++i) {
    const double s = i / 100.0;
    CHECK(quartic->GetNormFactor() * quartic->ComputeFunctionWeight(s) ==
          doctest::Approx(kernel(s * h, h)).epsilon(1e-9).scale(1 / (h * h * h)));
  }
}

TEST_CASE("VTK's Shepard sum equals the colour field to 1e-4") {
  compare("ball", test::ball(24));
  compare("noise", test::noise({16, 17, 18}, 21));
  const auto liver = test::visibleHumanLiver();
  if (liver)
    compare("Visible Human liver at 5 mm",
            discretize(*liver, latticeForSpacing(bounds(*liver), 0.005)));
}
