// resect.Organ: cells from a file, from a formula, or from an array.

#include <pybind11/stl.h>

#include "arrays.h"
#include "base/error.h"
#include "bindings.h"
#include "formats/labels/brought_organ.h"
#include "inventor/reading/model_file.h"
#include "io/cells/particle_file.h"
#include "io/operation_setup.h"
#include "organ/cell_labels.h"
#include "sph/discretization.h"

namespace resect::python {

namespace {

using Cells = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Labels = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

Discretization fromFile(const std::string& file, std::optional<double> spacing, double unit,
                        bool repair, bool onTable) {
  OrganSource source;
  source.file = file;
  source.spacing = spacing;
  source.unit = unit;
  source.repair = repair;
  source.onTable = onTable;
  if (isLabelled(file)) takeLabels(source);
  if (isBuiltIn(source) || !isParticleFile(file)) {
    if (!spacing)
      throw usageError("{}: give spacing, the side of a cell in m, such as 0.005", file);
  } else {
    source.spacing.reset();
  }
  return loadCells(source, readModel);
}

Vec3 vec3(const std::vector<double>& numbers, const char* what) {
  require(numbers.size() == 3, "{} has {} numbers; give 3", what, numbers.size());
  return {numbers[0], numbers[1], numbers[2]};
}

Discretization fromCells(const Cells& fill, double spacing, const std::vector<double>& origin,
                         const std::optional<Labels>& labels,
                         const std::vector<std::string>& names) {
  require(fill.ndim() == 3, "cells must be an array [nz, ny, nx], not one of {} axes", fill.ndim());
  require(spacing >= 1e-5 && spacing <= 0.1,
          "the spacing is {} m; give the side of a cell from 1e-5 to 0.1 m", spacing);
  Discretization cells;
  cells.lattice.origin = vec3(origin, "origin");
  cells.lattice.spacing = Vec3::Constant(spacing);
  cells.lattice.dims = Vec3i(int(fill.shape(2)), int(fill.shape(1)), int(fill.shape(0)));
  const auto count = std::size_t(cells.lattice.cellCount());
  cells.value = ColourValues(count);
  cells.inside.resize(count);
  for (std::size_t c = 0; c < count; ++c) {
    const float share = fill.data()[c];
    require(share >= 0 && share <= 1, "cell {} is filled by {}; give shares from 0 to 1", c, share);
    cells.value.set(c, 100 * share);
    cells.inside[c] = share >= 0.5f;
  }
  if (labels) {
    require(labels->ndim() == 3 && std::size_t(labels->size()) == count,
            "labels must have the shape of cells, [{}, {}, {}]", fill.shape(0), fill.shape(1),
            fill.shape(2));
    cells.label.assign(labels->data(), labels->data() + count);
    labelSkin(cells);
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i].empty()) cells.nameLabel(int(i), names[i]);
  requireSound(cells);
  require(cells.particleCount() > 0, "no cell is filled by a half or more; there is no organ");
  return cells;
}

std::vector<py::ssize_t> shape(const Discretization& d) {
  return {d.lattice.dims.z(), d.lattice.dims.y(), d.lattice.dims.x()};
}

py::array fill(const Discretization& d) {
  std::vector<float> shares(std::size_t(d.lattice.cellCount()));
  for (std::size_t c = 0; c < shares.size(); ++c) shares[c] = d.value[c] / 100;
  return owning(std::move(shares), shape(d));
}

py::array labelsOf(const Discretization& d) {
  std::vector<std::uint8_t> labels = d.label;
  labels.resize(std::size_t(d.lattice.cellCount()));
  return owning(std::move(labels), shape(d));
}

}  // namespace

void bindOrgan(py::module_& m) {
  py::class_<Discretization, std::shared_ptr<Discretization>>(
      m, "Organ", "An organ before the operation: cells on a cubic lattice. Lengths in m.")
      .def_static(
          "from_file", &fromFile, py::arg("file"), py::arg("spacing") = py::none(),
          py::arg("unit") = 1.0, py::arg("repair") = false, py::arg("on_table") = true,
          py::call_guard<py::gil_scoped_release>(),
          "From a closed mesh of any format that Resect reads, from a file of particles, or from a "
          "built-in organ (\"liver\", \"gallbladder\"). spacing: side of a cell, m. unit: metres "
          "per "
          "unit of the file. on_table: put it on the table, centred over the origin.")
      .def_static(
          "from_cells", &fromCells, py::arg("cells"), py::arg("spacing"),
          py::arg("origin") = std::vector<double>{0, 0, 0}, py::arg("labels") = py::none(),
          py::arg("label_names") = std::vector<std::string>{},
          "cells: [nz, ny, nx], the share of each cell that is tissue, 0 to 1 (or booleans). "
          "Cells of 0.5 or more become particles. spacing: m. origin: centre of the first "
          "cell, m. labels: [nz, ny, nx] uint8, the structure of each cell, 0 parenchyma.")
      .def_property_readonly(
          "shape", [](const Discretization& d) { return py::tuple(py::cast(shape(d))); },
          "(nz, ny, nx)")
      .def_property_readonly(
          "spacing", [](const Discretization& d) { return d.lattice.spacing.x(); },
          "Side of a cell, m.")
      .def_property_readonly(
          "origin", [](const Discretization& d) { return triple(d.lattice.origin); },
          "Centre of the first cell, m, [3].")
      .def_property_readonly("particles", &Discretization::particleCount)
      .def_property_readonly("volume_ml", [](const Discretization& d) { return 1e6 * d.volume(); })
      .def_property_readonly(
          "inside",
          [](const py::object& self) {
            const auto& d = self.cast<const Discretization&>();
            return readOnly(d.inside.data(), shape(d), self);
          },
          "[nz, ny, nx] uint8: 1 where there is a particle. Not a copy.")
      .def_property_readonly("fill", &fill, "[nz, ny, nx] float32: share of tissue, 0 to 1.")
      .def_property_readonly("labels", &labelsOf, "[nz, ny, nx] uint8: structure of each cell.")
      .def("label_name", &Discretization::labelName, py::arg("label"))
      .def(
          "save",
          [](const Discretization& d, const std::string& file) {
            writeParticleFile(file, {d, {"resect for Python", "", 1}});
          },
          py::arg("file"), "Writes *.resect-cells (all data) or *.dis (the thesis's text).")
      .def("__repr__", [](const Discretization& d) {
        return fmt::format("<resect.Organ {} particles {:g} mm apart>", d.particleCount(),
                           1e3 * d.lattice.spacing.x());
      });
}

}  // namespace resect::python
