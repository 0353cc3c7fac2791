// A name put on one or two lines where it has little room.
#pragma once

#include <QFontMetricsF>
#include <QString>

namespace tactus::workbench {

/// `label` as it fits into `width` px: on one line, or broken at the space or behind the vowel that leaves the most
/// even halves (`Laryngo-`, `pharynx`), with an ellipsis where even that is too wide.
QString brokenLabel(const QString& label, double width, const QFontMetricsF& metrics);

/// The widest line of the label once it is broken, in px.
double brokenWidth(const QString& label, const QFontMetricsF& metrics);

}  // namespace tactus::workbench
