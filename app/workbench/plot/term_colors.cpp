#include "app/workbench/plot/term_colors.h"

#include <cstdint>

#include "app/figures/colors.h"
#include "app/workbench/base/theme.h"

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

QColor termFill(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index) {
  const figures::Rgb color = figures::termColor(variable, terms, index);
  return {color.red, color.green, color.blue};
}

QColor termLine(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index) {
  return theme::readableLine(termFill(variable, terms, index));
}

QColor termText(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index) {
  return theme::readableText(termFill(variable, terms, index));
}

}  // namespace tactus::workbench
