// A block of elastic tissue on the table with tools: what instruments are tried on.
#pragma once

#include "simulation/simulation.h"
#include "support/block_organ.h"
#include "tissue/elastic/elastic_tissue.h"

namespace resect::test {

// Full cells of side `spacing`, from the origin on; E = 20 kPa.
inline Simulation elasticBlock(const Vec3i& dims, double spacing,
                               std::vector<std::unique_ptr<Tool>> tools) {
  Discretization cells = fullBlock(dims, spacing);
  cells.lattice.origin = Vec3::Constant(0.5 * spacing);
  TissueSettings settings;
  settings.drag = 6;
  TissueMaterial material;
  material.young = 20000;
  auto tissue = std::make_unique<ElasticTissue>(
      TissueCells{cells.lattice, cells.inside, {material}, {}}, settings);
  return Simulation(makeOrgan(std::move(cells), {}), std::move(tools), std::move(tissue));
}
inline Simulation elasticBlock(const Vec3i& dims, double spacing, std::unique_ptr<Tool> tool) {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(std::move(tool));
  return elasticBlock(dims, spacing, std::move(tools));
}

}  // namespace resect::test
