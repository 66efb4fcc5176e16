#include "organ_state.h"

#include <pybind11/stl.h>

#include "anatomy/vessel_map.h"
#include "arrays.h"
#include "base/error.h"
#include "operation/ledger/ledger.h"
#include "organ/vertex_labels.h"
#include "session.h"
#include "tissue/elastic/elastic_tissue.h"

namespace resect::python {

namespace {

const OperatedOrgan& operated(const OrganState& o) {
  return o.session->simulation->organs()[o.number];
}
const Lattice& latticeOf(const OrganState& o) { return operated(o).organ.rest.lattice; }

std::vector<py::ssize_t> shape(const OrganState& o) {
  const Vec3i& dims = latticeOf(o).dims;
  return {dims.z(), dims.y(), dims.x()};
}

py::array alive(const OrganState& o) {
  return readOnly(operated(o).organ.alive.data(), shape(o), o.simulation);
}

py::array labels(const OrganState& o) {
  const Organ& organ = operated(o).organ;
  std::vector<std::uint8_t> labels(organ.alive.size());
  for (std::size_t c = 0; c < labels.size(); ++c) labels[c] = organ.label(std::int64_t(c));
  return owning(std::move(labels), shape(o));
}

py::array segments(const OrganState& o) {
  const Organ& organ = operated(o).organ;
  std::vector<std::uint8_t> segments(organ.alive.size(), 0);
  if (organ.map && organ.map->segments) {
    const Lattice& lattice = organ.rest.lattice;
    for (std::size_t c = 0; c < segments.size(); ++c)
      if (organ.rest.inside[c])
        segments[c] =
            std::uint8_t(organ.map->segments->at(lattice.centre(lattice.cell(std::int64_t(c)))));
  }
  return owning(std::move(segments), shape(o));
}

const ElasticTissue& elastic(const OrganState& o, const char* what) {
  const auto* tissue = dynamic_cast<const ElasticTissue*>(operated(o).tissue.get());
  if (!tissue)
    throw usageError(
        "organ \"{}\" has no {}: its tissue stands still; set model = \"elastic\" in [tissue]",
        operated(o).name, what);
  return *tissue;
}

// Three arrays [nz, ny, nx] over the tissue's own memory, in which rows end with empty cells.
py::tuple components(const OrganState& o, const std::array<FloatArray, 3>& field,
                     const CellBox& box) {
  constexpr auto size = py::ssize_t(sizeof(float));
  py::tuple all(3);
  for (std::size_t a = 0; a < 3; ++a)
    all[a] = readOnly(field[a].data() + box.front, shape(o), o.simulation,
                      {box.strideZ * size, box.strideY * size, size});
  return all;
}

py::tuple displacement(const OrganState& o) {
  const ElasticState& state = elastic(o, "displacement").state();
  return components(o, state.u, state.box);
}
py::tuple velocity(const OrganState& o) {
  const ElasticState& state = elastic(o, "velocity").state();
  return components(o, state.v, state.box);
}

py::array cells(const OrganState& o) {
  const Organ& organ = operated(o).organ;
  std::vector<std::int64_t> all;
  all.reserve(std::size_t(organ.particles));
  for (std::size_t c = 0; c < organ.alive.size(); ++c)
    if (organ.alive[c]) all.push_back(std::int64_t(c));
  const auto count = py::ssize_t(all.size());
  return owning(std::move(all), {count});
}

using CellList = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

// Present positions of the given cells.
py::array positions(const OrganState& o, const CellList& cells) {
  const Lattice& lattice = latticeOf(o);
  const TissueModel& tissue = *operated(o).tissue;
  std::vector<float> all(3 * std::size_t(cells.size()));
  for (py::ssize_t i = 0; i < cells.size(); ++i) {
    const std::int64_t cell = cells.data()[i];
    require(cell >= 0 && cell < lattice.cellCount(), "there is no cell {} among {}", cell,
            lattice.cellCount());
    const Vec3 place = lattice.centre(lattice.cell(cell)) + tissue.displacement(cell);
    for (int a = 0; a < 3; ++a) all[3 * std::size_t(i) + std::size_t(a)] = float(place[a]);
  }
  return owning(std::move(all), {cells.size(), 3});
}

py::array points(const OrganState& o) {
  const Session::Points kept = o.session->points(o.number);
  auto* owner = new Session::Points(kept);
  const py::capsule capsule(owner, [](void* p) { delete static_cast<Session::Points*>(p); });
  return readOnly(kept->empty() ? nullptr : kept->data()->data(), {py::ssize_t(kept->size()), 3},
                  capsule);
}

py::array triangles(const OrganState& o) {
  const std::span<const Triangle> all = operated(o).organ.surface.triangles();
  std::vector<std::int32_t> corners;
  corners.reserve(3 * all.size());
  for (const Triangle& t : all)
    for (int a = 0; a < 3; ++a) corners.push_back(t[std::size_t(a)]);
  const auto count = py::ssize_t(all.size());
  return owning(std::move(corners), {count, 3});
}

py::array pointLabels(const OrganState& o) {
  std::vector<std::uint8_t> labels = vertexLabels(operated(o).organ);
  const auto count = py::ssize_t(labels.size());
  return owning(std::move(labels), {count});
}

Vec3 fractions(const OrganState& o, const std::array<double, 3>& at) {
  Aabb box;
  const Organ& organ = operated(o).organ;
  const Lattice& lattice = organ.rest.lattice;
  for (std::size_t c = 0; c < organ.rest.inside.size(); ++c)
    if (organ.rest.inside[c]) box.grow(lattice.centre(lattice.cell(std::int64_t(c))));
  box = box.padded(0.5 * lattice.spacing.x());
  return pointInBox(box, {at[0], at[1], at[2]});
}

}  // namespace

void bindOrganState(py::module_& m) {
  py::class_<OrganState>(
      m, "OrganState",
      "An organ of a simulation. Its arrays over cells show the present state: a step changes "
      "their "
      "numbers. Lengths in m. cell: index in the lattice, (k * ny + j) * nx + i.")
      .def_property_readonly("name", [](const OrganState& o) { return operated(o).name; })
      .def_property_readonly(
          "shape", [](const OrganState& o) { return py::tuple(py::cast(shape(o))); },
          "(nz, ny, nx)")
      .def_property_readonly("spacing",
                             [](const OrganState& o) { return latticeOf(o).spacing.x(); })
      .def_property_readonly(
          "origin", [](const OrganState& o) { return triple(latticeOf(o).origin); },
          "Centre of the first cell at rest, [3].")
      .def_property_readonly(
          "particles", [](const OrganState& o) { return operated(o).organ.particles; },
          "Number of particles now.")
      .def_property_readonly(
          "volume_ml", [](const OrganState& o) { return 1e6 * operated(o).organ.volume(); },
          "Of the tissue left.")
      .def_property_readonly(
          "removed_ml", [](const OrganState& o) { return 1e6 * operated(o).organ.removedVolume; })
      .def_property_readonly("moves",
                             [](const OrganState& o) { return operated(o).tissue->moves(); })
      .def_property_readonly("alive", &alive,
                             "[nz, ny, nx] uint8: 1 where there is a particle. Not a copy.")
      .def_property_readonly("displacement", &displacement,
                             "Three arrays [nz, ny, nx] float32, x, y and z, m. Not copies.")
      .def_property_readonly("velocity", &velocity, "As displacement, m/s.")
      .def_property_readonly("labels", &labels,
                             "[nz, ny, nx] uint8: structure of each cell; a copy.")
      .def_property_readonly("segments", &segments,
                             "[nz, ny, nx] uint8: Couinaud's segment of the liver, 1 to 8, at "
                             "rest; 0 outside the organ, and everywhere if "
                             "its vessels do not tell them. A copy.")
      .def("cells", &cells, "[n] int64: the cells that have particles now.")
      .def("positions", &positions, py::arg("cells"), "[n, 3] float32: where these cells are now.")
      .def(
          "points", &points,
          "[n, 3] float32: vertices of the surface now. Copied once in a step, however often it is "
          "asked for; an array that you keep stays as it was. Some entries are unused.")
      .def("triangles", &triangles, "[m, 3] int32: corners; unused triangles are (0, 0, 0).")
      .def("point_labels", &pointLabels, "[n] uint8: structure at each vertex.")
      .def(
          "at",
          [](const OrganState& o, const std::array<double, 3>& f) {
            return triple(fractions(o, f));
          },
          py::arg("fractions"),
          "The point of the organ at rest at fractions, 0 to 1, of its box, [3].")
      .def(
          "gripped",
          [](const OrganState& o, int tool) { return operated(o).tissue->gripped(tool); },
          py::arg("tool"), "Number of cells that an instrument holds.");
}

}  // namespace resect::python
