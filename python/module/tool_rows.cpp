#include "tool_rows.h"

#include <cmath>

#include "base/error.h"

namespace resect::python {

std::vector<ToolInput> inputsFrom(const Rows& rows, std::size_t tools) {
  require(
      rows.ndim() == 2 && std::size_t(rows.shape(0)) == tools && rows.shape(1) == kToolColumns,
      "tools must be an array [{}, {}]: a row per instrument with x y z qx qy qz qw squeeze pedal "
      "in_hand",
      tools, kToolColumns);
  const auto at = rows.unchecked<2>();
  std::vector<ToolInput> inputs(tools);
  for (std::size_t i = 0; i < tools; ++i) {
    const auto n = [&](int column) {
      const double value = at(pybind11::ssize_t(i), column);
      require(std::isfinite(value), "column {} of instrument {} is {}; give a number", column, i,
              value);
      return value;
    };
    ToolInput& one = inputs[i];
    one.pose.position = Vec3(n(0), n(1), n(2));
    one.pose.rotation = Eigen::Quaterniond(n(6), n(3), n(4), n(5));
    const double length = one.pose.rotation.norm();
    require(std::abs(length - 1) < 0.01,
            "the quaternion of instrument {} has the length {:.3g}; give one of length 1", i,
            length);
    if (std::abs(length - 1) > 1e-9) one.pose.rotation.normalize();
    one.squeeze = n(7);
    one.pedal = n(8);
    one.inHand = n(9) > 0.5;
  }
  return inputs;
}

pybind11::array_t<double> rowsFrom(const std::vector<ToolInput>& inputs) {
  pybind11::array_t<double> rows(
      {pybind11::ssize_t(inputs.size()), pybind11::ssize_t(kToolColumns)});
  auto at = rows.mutable_unchecked<2>();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const ToolInput& one = inputs[i];
    const Eigen::Quaterniond& q = one.pose.rotation;
    const Vec3& p = one.pose.position;
    const double row[kToolColumns] = {p.x(), p.y(), p.z(),       q.x(),     q.y(),
                                      q.z(), q.w(), one.squeeze, one.pedal, double(one.inHand)};
    for (int c = 0; c < kToolColumns; ++c) at(pybind11::ssize_t(i), c) = row[c];
  }
  return rows;
}

}  // namespace resect::python
