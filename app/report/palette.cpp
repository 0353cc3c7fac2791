#include "app/report/palette.h"

#include <algorithm>
#include <cmath>

namespace tactus::report {

namespace {

// Nine supports of the scale, red, green, blue of 255; between them straight lines.
constexpr std::array<std::array<double, 3>, 9> kScale = {{{68, 1, 84},
                                                          {71, 45, 123},
                                                          {59, 82, 139},
                                                          {44, 114, 142},
                                                          {33, 145, 140},
                                                          {40, 174, 128},
                                                          {94, 201, 98},
                                                          {173, 220, 48},
                                                          {253, 231, 37}}};

// Four supports of the ramp for things in an order.
constexpr std::array<std::array<double, 3>, 4> kRamp = {
    {{44, 62, 140}, {31, 122, 168}, {53, 168, 138}, {233, 168, 32}}};

template <std::size_t kSupports>
std::string between(const std::array<std::array<double, 3>, kSupports>& supports, double share, double light) {
  const double place = std::clamp(share, 0.0, 1.0) * (kSupports - 1);
  const auto low = std::min(static_cast<std::size_t>(place), kSupports - 2);
  const double part = place - static_cast<double>(low);
  std::string out = "#";
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double value = (supports[low][channel] * (1 - part) + supports[low + 1][channel] * part) * light;
    const int byte = static_cast<int>(std::lround(std::clamp(value, 0.0, 255.0)));
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    out += kDigits[static_cast<std::size_t>(byte / 16)];
    out += kDigits[static_cast<std::size_t>(byte % 16)];
  }
  return out;
}

}  // namespace

std::string rampColor(std::size_t index, std::size_t count, double light) {
  return between(kRamp, count < 2 ? 0 : static_cast<double>(index) / static_cast<double>(count - 1), light);
}

std::string scaleColor(double share, double light) { return between(kScale, share, light); }

}  // namespace tactus::report
