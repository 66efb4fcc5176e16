// Sets up the state of elastic tissue, and updates this state after bonds were severed or cells
// were removed.
//
// Edits sever bonds, the connections between neighbouring cells. Afterwards, refreshCells() updates
// the moment matrices of the cells whose bonds changed. It also updates the chunks (groups of
// sixteen cells) that contain these cells or their neighbours. No other cells are computed again.
// refreshCells() takes some microseconds per hundred cells.
#pragma once

#include <span>

#include "tissue/elastic/elastic_state.h"
#include "tissue/material.h"

namespace resect {

// Tissue at rest, with a bond between every two solid cells that are neighbours. penalty: alpha of
// docs/methods/tissue.md, 0 or more. Throws Error if the lattice's cells are not cubes.
ElasticState makeElasticState(const TissueCells& cells, double penalty);

// Severs a bond, if it exists. cell: index in the CellBox, as in all functions below.
void severBond(ElasticState& s, std::int32_t cell, int direction);
// Removes the cell: it then has no bonds, no mass and no motion.
void removeCell(ElasticState& s, std::int32_t cell);

// Allocates the arrays that the Maxwell branches of the state's materials need; arrays that exist
// already stay as they are. Call after `materials` was changed.
void allocateBranches(ElasticState& s);

// Throws Error if a value of the material is out of range.
void checkMaterial(const TissueMaterial& material);
// Returns the material's index in s.materials. A material that is not yet there is appended. Throws
// Error if there are 256 materials already.
std::uint8_t materialNumber(ElasticState& s, const TissueMaterial& material);
// Computes masses, stiffnesses and plane weights of these cells. Call after `solid` or `material`
// of these cells was changed. Call refreshCells() next. Cells that are not solid lose their motion
// and forces.
void remakeCells(ElasticState& s, std::span<const std::int32_t> cells);

// Computes ElasticState::inverseMoment, skew and kappa of these cells, then calls refreshChunks().
// Call after the bonds of these cells were changed.
void refreshCells(ElasticState& s, std::span<const std::int32_t> cells);
// Updates the chunks that contain one of these cells or one of their neighbours. Call after `held`
// or `loaded` of these cells was changed.
void refreshChunks(ElasticState& s, std::span<const std::int32_t> cells);

}  // namespace resect
