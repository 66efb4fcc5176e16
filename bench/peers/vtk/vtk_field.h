// The colour field and its surface by VTK: vtkSPHInterpolator with its quartic kernel on all nodes
// of our grid, then vtkFlyingEdges3D.
#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "sph/colour_field.h"

namespace resect::bench {

class VtkField {
 public:
  // The same particles and the same nodes.
  VtkField(const Discretization& cells, const ColourField& field);

  void recompute(bool withNormals = false);  // field and surface, from nothing

  // Largest difference from our field over 100, on the nodes that it stores; after recompute().
  double difference(const ColourField& field) const;
  vtkIdType triangles() const { return surface_->GetNumberOfPolys(); }

 private:
  vtkNew<vtkPolyData> particles_;
  vtkNew<vtkImageData> nodes_;
  double h_;
  vtkSmartPointer<vtkImageData> values_;
  vtkSmartPointer<vtkPolyData> surface_;
};

}  // namespace resect::bench
