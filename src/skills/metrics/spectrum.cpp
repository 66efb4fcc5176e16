#include "skills/metrics/spectrum.h"

#include <algorithm>
#include <bit>
#include <complex>
#include <numeric>
#include <unsupported/Eigen/FFT>

#include "base/error.h"

namespace resect {

std::vector<double> magnitudes(std::span<const double> values, std::size_t size) {
  require(std::has_single_bit(size) && size >= values.size() && size >= 2,
          "a spectrum of {} values was to have {} points; give a power of two that is no less",
          values.size(), size);
  std::vector<double> padded(values.begin(), values.end());
  padded.resize(size, 0.0);
  std::vector<std::complex<double>> transformed;
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  fft.fwd(transformed, padded);
  std::vector<double> sizes(transformed.size());
  std::ranges::transform(transformed, sizes.begin(),
                         [](const std::complex<double>& c) { return std::abs(c); });
  return sizes;
}

std::optional<double> frequency95(std::span<const double> speed, double interval) {
  if (speed.size() < 2) return {};
  const double mean = std::accumulate(speed.begin(), speed.end(), 0.0) / double(speed.size());
  std::vector<double> varied(speed.begin(), speed.end());
  for (double& v : varied) v -= mean;
  const std::size_t size = std::bit_ceil(speed.size());
  std::vector<double> power = magnitudes(varied, size);
  for (double& p : power) p *= p;
  const double all = std::accumulate(power.begin(), power.end(), 0.0);
  if (!(all > 1e-20)) return {};
  double sum = 0;
  for (std::size_t i = 0; i < power.size(); ++i) {
    sum += power[i];
    if (sum >= 0.95 * all) return double(i) / (double(size) * interval);
  }
  return {};
}

}  // namespace resect
