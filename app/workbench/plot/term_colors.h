// The colors of terms on the current look (app/figures/colors.h says what they mean).
#pragma once

#include <QColor>
#include <cstddef>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// Of bars, chips and areas.
QColor termFill(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index);
/// Of lines and handles: contrast 3 to a card.
QColor termLine(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index);
/// Of small text: contrast 4.5 to a card.
QColor termText(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index);

}  // namespace tactus::workbench
