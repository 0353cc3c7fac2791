#include "app/workbench/plot/term_colors.h"

#include "app/figures/colors.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench {

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
