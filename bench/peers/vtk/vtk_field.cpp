#include "peers/vtk/vtk_field.h"

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSPHInterpolator.h>
#include <vtkSPHQuarticKernel.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>
#include <cmath>

namespace resect::bench {

VtkField::VtkField(const Discretization& cells, const ColourField& field)
    : h_(kSmoothingPerSpacing * cells.lattice.spacing.x()) {
  // Without mass and density VTK takes h^3 as a particle's volume; weighting the values by what a
  // cell has more spares it two look-ups per neighbour.
  const double share = cells.lattice.cellVolume() / (h_ * h_ * h_) / 100;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> colour;
  colour->SetName("colour");
  for (std::int64_t i = 0; i < cells.lattice.cellCount(); ++i)
    if (cells.value[i] > 0) {
      points->InsertNextPoint(cells.lattice.centre(cells.lattice.cell(i)).data());
      colour->InsertNextValue(float(share * cells.value[i]));
    }
  particles_->SetPoints(points);
  particles_->GetPointData()->AddArray(colour);
  const Vec3i dims = field.nodeDims();
  const Vec3 pitch = cells.lattice.spacing / field.refine();
  nodes_->SetDimensions(dims.data());
  nodes_->SetOrigin(field.nodePosition(Vec3::Zero()).data());
  nodes_->SetSpacing(pitch.data());
}

void VtkField::recompute(bool withNormals) {
  vtkNew<vtkSPHQuarticKernel> quartic;
  quartic->SetSpatialStep(h_);
  vtkNew<vtkStaticPointLocator> locator;
  vtkNew<vtkSPHInterpolator> interpolator;
  interpolator->SetInputData(nodes_);
  interpolator->SetSourceData(particles_);
  interpolator->SetKernel(quartic);
  interpolator->SetLocator(locator);
  interpolator->ComputeShepardSumOff();
  interpolator->SetNullPointsStrategyToNullValue();
  interpolator->SetNullValue(0);
  interpolator->Update();
  values_ = vtkImageData::SafeDownCast(interpolator->GetOutput());
  values_->GetPointData()->SetActiveScalars("colour");
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(values_);
  edges->SetValue(0, 0.5);
  edges->SetComputeNormals(withNormals);
  edges->Update();
  surface_ = edges->GetOutput();
}

double VtkField::difference(const ColourField& field) const {
  const auto* theirs = vtkFloatArray::SafeDownCast(values_->GetPointData()->GetArray("colour"));
  const Vec3i dims = field.nodeDims();
  double worst = 0;
  for (std::int64_t b = 0; b < field.brickCount(); ++b) {
    if (field.slot(b) < 0) continue;
    const auto values = field.values(field.slot(b));
    for (int i = 0; i < kBrickSize; ++i) {
      const Vec3i n = kBrickNodes * field.brick(b) + Vec3i(i & 3, i >> 2 & 3, i >> 4);
      const vtkIdType at = (vtkIdType(n.z()) * dims.y() + n.y()) * dims.x() + n.x();
      worst = std::max(worst, std::abs(values[i] / 100.0 - theirs->GetValue(at)));
    }
  }
  return worst;
}

}  // namespace resect::bench
