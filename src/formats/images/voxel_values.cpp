#include "formats/images/voxel_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace resect {
namespace {

static_assert(std::endian::native == std::endian::little);

template <typename T>
double numberAt(const char* at, bool bigEndian) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  if (bigEndian) std::ranges::reverse(bytes);
  return double(std::bit_cast<T>(bytes));
}

// Calls visit(value) for each voxel in order.
template <typename T, typename Visit>
void visitValues(const VoxelNumbers& n, std::int64_t count, const Visit& visit) {
  const char* at = n.bytes.data() + std::size_t(n.first) * sizeof(T);
  const std::size_t step = std::size_t(n.stride) * sizeof(T);
  for (std::int64_t i = 0; i < count; ++i, at += step)
    visit(n.slope * numberAt<T>(at, n.bigEndian) + n.intercept);
}

template <typename Visit>
void visitValues(const VoxelNumbers& n, std::int64_t count, const Visit& visit) {
  switch (n.type) {
    case VoxelType::U8:
      return visitValues<std::uint8_t>(n, count, visit);
    case VoxelType::I8:
      return visitValues<std::int8_t>(n, count, visit);
    case VoxelType::U16:
      return visitValues<std::uint16_t>(n, count, visit);
    case VoxelType::I16:
      return visitValues<std::int16_t>(n, count, visit);
    case VoxelType::U32:
      return visitValues<std::uint32_t>(n, count, visit);
    case VoxelType::I32:
      return visitValues<std::int32_t>(n, count, visit);
    case VoxelType::U64:
      return visitValues<std::uint64_t>(n, count, visit);
    case VoxelType::I64:
      return visitValues<std::int64_t>(n, count, visit);
    case VoxelType::F32:
      return visitValues<float>(n, count, visit);
    case VoxelType::F64:
      return visitValues<double>(n, count, visit);
  }
}

// Finds the labels in the values, in the order in which they come.
class LabelFinder {
 public:
  explicit LabelFinder(const std::string& path) : path_(path) {}

  // The number of the label with this value in values(), from 1; 0 for value 0.
  std::uint16_t operator()(double value) {
    if (value != lastValue_) lastLabel_ = find(value);
    lastValue_ = value;
    labelled_ += lastLabel_ > 0;
    agreeLabelled_ += lastLabel_ > 0 && before_ == lastLabel_;
    before_ = lastLabel_;
    return lastLabel_;
  }

  const std::vector<std::int64_t>& values() const { return values_; }

  // Whether the values are those of a scan: many, and neighbours mostly differ.
  bool isNoise() const { return values_.size() > 20 && agreeLabelled_ < labelled_ / 2; }

 private:
  std::uint16_t find(double value) {
    if (!std::isfinite(value) || value != std::floor(value) || std::abs(value) > 1e15)
      throw notLabels(path_, fmt::format("it has values such as {:.4g}", value));
    if (value < 0) throw notLabels(path_, fmt::format("it has values below 0, such as {}", value));
    if (value == 0) return 0;
    const auto [at, isNew] = numbers_.try_emplace(std::int64_t(value), values_.size() + 1);
    if (isNew) {
      if (int(values_.size()) == kMostLabels)
        throw notLabels(path_, fmt::format("it has more than {} values", kMostLabels));
      values_.push_back(std::int64_t(value));
    }
    return std::uint16_t(at->second);
  }

  const std::string& path_;
  std::map<std::int64_t, std::size_t> numbers_;
  std::vector<std::int64_t> values_;
  double lastValue_ = 0;
  std::uint16_t lastLabel_ = 0, before_ = 0;
  std::int64_t labelled_ = 0, agreeLabelled_ = 0;
};

}  // namespace

std::size_t bytesOf(VoxelType type) {
  constexpr std::array<std::size_t, 10> kBytes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kBytes[std::size_t(type)];
}

Error notLabels(const std::string& path, const std::string& why) {
  return error("{}: is a scan and not its labels: {}; label its organs ({}) and take the labels",
               path, why, kLabelMakers);
}

void addLayer(const std::string& path, LabelImage& image, const VoxelNumbers& numbers,
              const std::map<std::int64_t, std::string>& names) {
  const std::int64_t count = image.voxelCount();
  const std::size_t all = numbers.bytes.size() / bytesOf(numbers.type);
  if (all < std::size_t((count - 1) * numbers.stride + numbers.first + 1))
    throw error("{}: ends early: it promises {} voxels and holds {}; copy or export it again", path,
                count * numbers.stride, all);
  if (int(image.layers.size()) == kMostLayers)
    throw error("{}: has more than {} layers of labels; export fewer segments", path, kMostLayers);
  RawArray<std::uint16_t> layer;
  layer.reserve(std::size_t(count));
  LabelFinder find(path);
  visitValues(numbers, count, [&](double value) { layer.push_back(find(value)); });
  if (find.isNoise())
    throw notLabels(
        path, fmt::format("it has {} values, and neighbours mostly differ", find.values().size()));
  // The labels in ascending order of their values, after those of earlier layers.
  std::vector<std::int64_t> values = find.values();
  std::ranges::sort(values);
  const std::size_t before = image.labels.size();
  if (before + values.size() > std::size_t(kMostLabels))
    throw error("{}: has more than {} labels; export fewer segments", path, kMostLabels);
  std::vector<std::uint16_t> numberOf(values.size() + 1, 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto sorted = std::ranges::lower_bound(values, find.values()[i]) - values.begin();
    numberOf[i + 1] = std::uint16_t(before + std::size_t(sorted) + 1);
  }
  for (const std::int64_t value : values) {
    const auto name = names.find(value);
    image.labels.push_back(
        {value, name == names.end() ? "" : name->second, int(image.layers.size()), 0});
  }
  for (std::uint16_t& voxel : layer) {
    voxel = numberOf[voxel];
    if (voxel > 0) ++image.labels[std::size_t(voxel) - 1].voxels;
  }
  image.layers.push_back(std::move(layer));
}

}  // namespace resect
