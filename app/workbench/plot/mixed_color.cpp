#include "app/workbench/plot/mixed_color.h"

#include <cstdint>

#include "app/figures/colors.h"

namespace tactus::workbench {
namespace {

figures::Rgb rgbOf(const QColor& color) {
  return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
          static_cast<std::uint8_t>(color.blue())};
}

}  // namespace

QColor mixedColor(const QColor& from, const QColor& to, double share) {
  const figures::Rgb mix = figures::mixed(rgbOf(from), rgbOf(to), share);
  return {mix.red, mix.green, mix.blue};
}

double contrastOf(const QColor& one, const QColor& other) { return figures::contrast(rgbOf(one), rgbOf(other)); }

}  // namespace tactus::workbench
