// Messages of a view to the person, wherever the view stands in the window.
#pragma once

#include <QString>

class QWidget;

namespace tactus::workbench {

/// In the banner of the main window around `from`; nothing where there is none.
void sayError(QWidget& from, const QString& sentence);
/// In its strip, for some seconds.
void sayDone(QWidget& from, const QString& sentence);

}  // namespace tactus::workbench
