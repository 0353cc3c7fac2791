// Messages from a view to the user, wherever the view is in the window.
#pragma once

#include <QString>

class QWidget;

namespace tactus::workbench {

/// A window that shows messages. Views reach the window around them with `sayError` and `sayDone`.
class MessagePlace {
 public:
  virtual ~MessagePlace() = default;
  /// A failure and its reason. The message stays until the user closes it.
  virtual void showError(const QString& sentence) = 0;
  /// A completed action. The strip shows it for some seconds.
  virtual void say(const QString& sentence) = 0;
};

/// Calls `showError` of the window around `from`; does nothing without one.
void sayError(QWidget& from, const QString& sentence);
/// Calls `say` of the window around `from`; does nothing without one.
void sayDone(QWidget& from, const QString& sentence);

}  // namespace tactus::workbench
