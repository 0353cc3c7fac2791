// A line at the top of a menu that says what it is about.
#pragma once

#include <QMenu>

namespace tactus::workbench {

/// Adds `text` above the entries that follow. The menu is as wide as it: Qt cuts the text of a section to the entries.
void addMenuHeading(QMenu& menu, const QString& text);

}  // namespace tactus::workbench
