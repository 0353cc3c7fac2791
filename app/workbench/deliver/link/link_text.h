// How the state of the live link reads on the screen.
#pragma once

#include <QString>

namespace tactus::workbench {

class LinkController;

/// `Serving 127.0.0.1:45123 · 2 connected`; empty while nothing is served.
QString servingText(const LinkController& link);
/// The same for a narrow place: `Serving · 2`.
QString shortServingText(const LinkController& link);
/// Who is connected: `2 connected`, `none connected`, `the last left at 14:32`.
QString connectedText(const LinkController& link);

}  // namespace tactus::workbench
