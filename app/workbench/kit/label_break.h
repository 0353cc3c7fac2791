// Fits a name into a narrow place, on one or two lines.
#pragma once

#include <QFontMetricsF>
#include <QString>

namespace tactus::workbench {

/// `label` fitted into `width` px: on one line, or on two lines of nearly equal length. The break is at a space or
/// after a vowel (`Laryngo-`, `pharynx`). Text that is still too wide ends in an ellipsis.
QString brokenLabel(const QString& label, double width, const QFontMetricsF& metrics);

/// The width of the widest line after the break, px.
double brokenWidth(const QString& label, const QFontMetricsF& metrics);

}  // namespace tactus::workbench
