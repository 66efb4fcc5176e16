// resect.Edit: what can be done to tissue, as values.

#include "organ/edit.h"

#include <array>

#include "arrays.h"
#include "base/error.h"
#include "bindings.h"
#include "tissue/stencil.h"

namespace resect::python {

namespace {

constexpr const char* kNames[] = {"remove", "sever",  "incise", "grip",  "release",
                                  "label",  "clip",   "heat",   "clamp", "suck",
                                  "press",  "divide", "tear",   "carve"};

template <typename What>
TissueEdit of(What what, int organ) {
  return {organ, -1, std::move(what)};
}

Vec3 place(double x, double y, double z) { return {x, y, z}; }

using Edge = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<Vec3> points(const Edge& edge) {
  require(edge.ndim() == 2 && edge.shape(1) == 3 && edge.shape(0) >= 2,
          "an edge of a cut must be an array [n, 3] with two points or more");
  std::vector<Vec3> all;
  for (py::ssize_t i = 0; i < edge.shape(0); ++i)
    all.push_back(place(edge.at(i, 0), edge.at(i, 1), edge.at(i, 2)));
  return all;
}

Incision incision(const Edge& before, const Edge& after) {
  const std::vector<Vec3> from = points(before), to = points(after);
  require(from.size() == to.size(), "the two edges have {} and {} points; give as many in both",
          from.size(), to.size());
  return {ruledBlade(from, to)};
}

}  // namespace

void bindEdits(py::module_& m) {
  const auto organ = py::arg("organ") = 0;
  py::class_<TissueEdit>(m, "Edit",
                         "A change of tissue, for Simulation.step(edits=[...]). cell: index in the "
                         "organ's lattice, (k * ny + j) * nx + i. Lengths in m.")
      .def_static(
          "remove",
          [](std::int64_t cell, double spares, int o) {
            return of(RemoveCell{cell, spares}, o);
          },
          py::arg("cell"), py::arg("spares") = 1.0, organ,
          "Removes a particle. Vessels of at least the radius spares, m, stay.")
      .def_static(
          "carve",
          [](const std::array<double, 3>& from, const std::array<double, 3>& to, double radius,
             double spares, int o) {
            return of(Carve{{place(from[0], from[1], from[2]), place(to[0], to[1], to[2]), radius},
                            spares},
                      o);
          },
          py::arg("start"), py::arg("end"), py::arg("radius"), py::arg("spares") = 1.0, organ,
          "Takes away the tissue within a radius, m, of a straight line in the tissue at rest. "
          "Vessels of at least the radius spares, m, stay.")
      .def_static(
          "sever",
          [](std::int64_t cell, int direction, int o) {
            require(direction >= 0 && direction < kDirections,
                    "direction {} was given; use 0 to {}", direction, kDirections - 1);
            return of(SeverBond{cell, direction}, o);
          },
          py::arg("cell"), py::arg("direction"), organ,
          "Severs the bond of a cell in a direction, 0 to 25.")
      .def_static(
          "tear",
          [](std::int64_t cell, int direction, double spares, int o) {
            require(direction >= 0 && direction < kDirections,
                    "direction {} was given; use 0 to {}", direction, kDirections - 1);
            return of(TearBond{cell, direction, spares}, o);
          },
          py::arg("cell"), py::arg("direction"), py::arg("spares") = 0.001, organ,
          "Severs the bond of a cell in a direction, 0 to 25. Vessels of at least the radius "
          "spares, m, stay.")
      .def_static(
          "incise", [](const Edge& a, const Edge& b, int o) { return of(incision(a, b), o); },
          py::arg("before"), py::arg("after"), organ,
          "Cuts where an edge moves from one position to the next: two arrays [n, 3], in the "
          "tissue at rest, m.")
      .def_static(
          "label",
          [](std::int64_t cell, int label, int o) {
            require(label >= 0 && label <= 255, "label {} was given; use 0 to 255", label);
            return of(SetLabel{cell, std::uint8_t(label)}, o);
          },
          py::arg("cell"), py::arg("label"), organ)
      .def_static(
          "clip",
          [](int segment, double share, int o) {
            return of(PlaceClip{segment, share}, o);
          },
          py::arg("segment"), py::arg("share"), organ,
          "Closes a vessel at a share, 0 to 1, of a segment.")
      .def_static(
          "divide",
          [](int segment, double share, int o) {
            return of(DivideVessel{segment, share}, o);
          },
          py::arg("segment"), py::arg("share"), organ, "Cuts through a vessel.")
      .def_static(
          "heat",
          [](double x, double y, double z, double radius, double power, int o) {
            return of(Heat{place(x, y, z), radius, power}, o);
          },
          py::arg("x"), py::arg("y"), py::arg("z"), py::arg("radius"), py::arg("power"), organ,
          "Heats the tissue at rest round a point for the whole frame. power: W.")
      .def_static(
          "clamp", [](bool closed, int o) { return of(ClampInflow{closed}, o); },
          py::arg("closed") = true, organ, "Closes or opens the inflow before the organ.")
      .def_static(
          "suck",
          [](double x, double y, double z, double radius, double rate, int o) {
            return of(Suction{place(x, y, z), radius, rate}, o);
          },
          py::arg("x"), py::arg("y"), py::arg("z"), py::arg("radius"), py::arg("rate"), organ,
          "Takes blood near a point of the world for the whole frame. rate: at most, m^3/s.")
      .def_static(
          "press",
          [](double x, double y, double z, double radius, double pressure, double soaks, int o) {
            return of(Press{place(x, y, z), radius, pressure, soaks}, o);
          },
          py::arg("x"), py::arg("y"), py::arg("z"), py::arg("radius"), py::arg("pressure"),
          py::arg("soaks") = 0.0, organ,
          "Presses on bleeding vessels. pressure: Pa. soaks: at most, m^3/s.")
      .def_readonly("organ", &TissueEdit::organ)
      .def_readonly("tool", &TissueEdit::tool, "Number of the instrument that made it; -1: none.")
      .def_property_readonly("kind", [](const TissueEdit& e) { return kNames[e.what.index()]; })
      .def("__repr__", [](const TissueEdit& e) {
        return fmt::format("<resect.Edit {} organ {}>", kNames[e.what.index()], e.organ);
      });
  static_assert(std::variant_size_v<decltype(TissueEdit::what)> == std::size(kNames));
}

}  // namespace resect::python
