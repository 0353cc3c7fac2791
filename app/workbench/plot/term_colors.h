// The colors of terms on the current look (app/figures/colors.h says what they mean).
#pragma once

#include <QColor>
#include <cstddef>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

// Mixes two colors, as figures::mixed does for the report.

/// `share` in [0, 1] of `to`, the rest of `from`. Both are opaque.
QColor mixedColor(const QColor& from, const QColor& to, double share);

/// The contrast of WCAG 2.1 between opaque colors: 1 to 21.
double contrastOf(const QColor& one, const QColor& other);

/// Of bars, chips and areas.
QColor termFill(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index);
/// Of lines and handles: contrast 3 to a card.
QColor termLine(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index);
/// Of small text: contrast 4.5 to a card.
QColor termText(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index);

}  // namespace tactus::workbench
