// How is the state of elastic tissue made, and kept right when bonds are severed and cells removed?
//
// Edits change bonds; the moment matrices of the cells concerned and the kinds of their chunks
// follow with refreshCells(), which costs microseconds per hundred cells and depends on nothing but
// the cells named.
#pragma once

#include <span>

#include "tissue/elastic/elastic_state.h"
#include "tissue/material.h"

namespace resect {

// At rest, all solid neighbours bonded. `penalty`: alpha, 0 or more
// (docs/methods/tissue.md). Throws Error when the lattice is
// not cubic.
ElasticState makeElasticState(const TissueCells& cells, double penalty);

// Cells are indices in the box. The bond need not be there.
void severBond(ElasticState& s, std::int32_t cell, int direction);
// The cell is no more: no bonds, no mass, no motion.
void removeCell(ElasticState& s, std::int32_t cell);

// Throws Error when a value is out of range.
void checkMaterial(const TissueMaterial& material);
// Its number in the list, where it is put if it is not there; at most 256.
std::uint8_t materialNumber(ElasticState& s, const TissueMaterial& material);
// After `solid` or `material` of these cells changed: masses, stiffnesses, plane weights; what is
// not solid has no motion and no forces. refreshCells() follows.
void remakeCells(ElasticState& s, std::span<const std::int32_t> cells);

// After the bonds of these cells changed: inverse moments, skews, gradient flags, chunks.
void refreshCells(ElasticState& s, std::span<const std::int32_t> cells);
// After `held` or `loaded` of these cells changed: chunks alone.
void refreshChunks(ElasticState& s, std::span<const std::int32_t> cells);

}  // namespace resect
