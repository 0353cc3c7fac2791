// Messages of a view to the person, wherever the view stands in the window.
#pragma once

#include <QString>

class QWidget;

namespace tactus::workbench {

/// A window that shows messages. Views find the one around them with `sayError` and `sayDone`.
class MessagePlace {
 public:
  virtual ~MessagePlace() = default;
  /// What did not happen, and why: stays until the person closes it.
  virtual void showError(const QString& sentence) = 0;
  /// What was done: in the strip, for some seconds.
  virtual void say(const QString& sentence) = 0;
};

/// `showError` of the window around `from`; nothing happens without one.
void sayError(QWidget& from, const QString& sentence);
/// `say` of the window around `from`; nothing happens without one.
void sayDone(QWidget& from, const QString& sentence);

}  // namespace tactus::workbench
