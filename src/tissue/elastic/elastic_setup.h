// Sets up the state of elastic tissue and updates it after bonds are severed or cells removed.
//
// Edits change bonds; refreshCells() then updates the moment matrices of the cells concerned and
// the flags of their chunks, in microseconds per hundred cells. The result depends on the named
// cells alone.
#pragma once

#include <span>

#include "tissue/elastic/elastic_state.h"
#include "tissue/material.h"

namespace resect {

// At rest, all solid neighbours bonded. `penalty`: alpha, 0 or more
// (docs/methods/tissue.md). Throws Error when the lattice is
// not cubic.
ElasticState makeElasticState(const TissueCells& cells, double penalty);

// Cells are indices in the box. The bond need not exist.
void severBond(ElasticState& s, std::int32_t cell, int direction);
// Removes the cell: no bonds, no mass, no motion.
void removeCell(ElasticState& s, std::int32_t cell);

// Throws Error when a value is out of range.
void checkMaterial(const TissueMaterial& material);
// The material's index in the list; appended if it is new. At most 256.
std::uint8_t materialNumber(ElasticState& s, const TissueMaterial& material);
// After `solid` or `material` of these cells changed: masses, stiffnesses, plane weights; cells
// that are not solid get no motion and no forces. refreshCells() follows.
void remakeCells(ElasticState& s, std::span<const std::int32_t> cells);

// After the bonds of these cells changed: inverse moments, skews, gradient flags, chunks.
void refreshCells(ElasticState& s, std::span<const std::int32_t> cells);
// After `held` or `loaded` of these cells changed: chunks alone.
void refreshChunks(ElasticState& s, std::span<const std::int32_t> cells);

}  // namespace resect
