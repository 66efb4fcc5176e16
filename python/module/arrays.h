// Numpy arrays over memory of the library. Nothing is copied: the array keeps alive the Python
// object that owns the memory.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace resect::python {

namespace py = pybind11;

// An array that can only be read. strides: in bytes; empty: C order.
template <typename T>
py::array readOnly(const T* data, std::vector<py::ssize_t> shape, py::handle owner,
                   std::vector<py::ssize_t> strides = {}) {
  const py::dtype type = py::dtype::of<T>();
  py::array array = strides.empty() ? py::array(type, shape, data, owner)
                                    : py::array(type, shape, strides, data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

// An array that owns `values`: the vector is moved into it.
template <typename T>
py::array owning(std::vector<T> values, std::vector<py::ssize_t> shape) {
  auto* kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array(py::dtype::of<T>(), std::move(shape), kept->data(), owner);
}

// [n, 3] of double over vectors that lie one after the other.
inline py::array vectors(const std::vector<Vec3>& values, py::handle owner) {
  return readOnly(values.empty() ? nullptr : values[0].data(), {py::ssize_t(values.size()), 3},
                  owner);
}

inline py::array_t<double> triple(const Vec3& v) {
  py::array_t<double> array(3);
  for (int a = 0; a < 3; ++a) array.mutable_at(a) = v[a];
  return array;
}

}  // namespace resect::python
