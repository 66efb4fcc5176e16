// Cell fields: values that each cell has besides its colour value (how full of tissue it is). These
// values are the label of the structure to which the cell belongs (0: the organ's ordinary tissue,
// its parenchyma), and whether heat has coagulated the cell.
//
// A field takes no memory until one of its values differs from the start value. To add a field, add
// a member to CellFields and add it to visit() and fit(). Then saving, comparing and hashing
// include the field (docs/how-to/add_a_cell_field.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sph/lattice.h"

namespace resect {

template <typename T>
class CellField {
 public:
  CellField() = default;
  // values: one per cell; if empty, all cells have the value `start`.
  explicit CellField(std::vector<T> values, T start = T())
      : values_(std::move(values)), start_(start) {}

  T operator[](std::int64_t cell) const {
    return values_.empty() ? start_ : values_[std::size_t(cell)];
  }
  void set(const Lattice& lattice, std::int64_t cell, T value) {
    if (values_.empty() && value == start_) return;
    if (values_.empty()) values_.assign(std::size_t(lattice.cellCount()), start_);
    values_[std::size_t(cell)] = value;
  }
  bool empty() const { return values_.empty(); }
  std::span<T> values() { return values_; }
  // Whether there is an entry for each cell of the lattice, or no entry at all.
  bool fits(const Lattice& lattice) const {
    return values_.empty() || std::int64_t(values_.size()) == lattice.cellCount();
  }

  template <class Visitor>
  void visit(Visitor& v) {
    v("values", values_);
  }

 private:
  std::vector<T> values_;
  T start_ = T();
};

struct CellFields {
  // Number of the structure that the cell belongs to. 0 is the organ's own parenchyma;
  // Discretization::labelNames has the names of the other structures.
  CellField<std::uint8_t> label;
  CellField<std::uint8_t> coagulated;  // 1: heat has changed most of the cell's tissue

  template <class Visitor>
  void visit(Visitor& v, const CellOrder& order) {
    v.perCell("label", label, order);
    v.perCell("coagulated", coagulated, order);
  }
  bool fit(const Lattice& lattice) const { return label.fits(lattice) && coagulated.fits(lattice); }
};

}  // namespace resect
