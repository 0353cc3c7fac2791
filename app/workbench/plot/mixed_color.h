// Mixes two colors, as figures::mixed does for the report.
#pragma once

#include <QColor>

namespace tactus::workbench {

/// `share` in [0, 1] of `to`, the rest of `from`. Both are opaque.
QColor mixedColor(const QColor& from, const QColor& to, double share);

/// The contrast of WCAG 2.1 between opaque colors: 1 to 21.
double contrastOf(const QColor& one, const QColor& other);

}  // namespace tactus::workbench
