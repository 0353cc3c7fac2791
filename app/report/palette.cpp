#include "app/report/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tactus::report {

namespace {

std::string lit(const figures::Rgb& color, double light) {
  const auto channel = [light](std::uint8_t byte) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(byte * light, 0.0, 255.0)));
  };
  return figures::hex({channel(color.red), channel(color.green), channel(color.blue)});
}

}  // namespace

std::string scaleColor(double share, double light) { return lit(figures::forceRamp(share), light); }

std::string_view seriesColor(std::size_t index) {
  static const std::array<std::string, kSeriesColors> kColors = [] {
    std::array<std::string, kSeriesColors> colors;
    for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = figures::hex(figures::expertColor(i));
    return colors;
  }();
  return kColors[index % kColors.size()];
}

std::string readableText(const figures::Rgb& color) {
  return figures::hex(figures::readable(color, {0xFF, 0xFF, 0xFF}, {0x1B, 0x1F, 0x24}, 4.5));
}

}  // namespace tactus::report
