// Messages from a view to the user, wherever the view is in the window.
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace tactus::workbench {

/// What a message offers to do about it.
struct MessageAct {
  QString text;  ///< of the button: a verb, as in "Save elsewhere…"
  std::function<void()> run;
};

/// A window that shows messages. Views reach the window around them with `sayError` and `sayDone`.
class MessagePlace {
 public:
  virtual ~MessagePlace() = default;
  /// What did not happen, and why, with a button for what helps; an act without text: none. The message stays until the
  /// user closes it.
  virtual void showError(const QString& sentence, MessageAct act) = 0;
  /// A completed action. The strip shows it for some seconds.
  virtual void say(const QString& sentence) = 0;
};

/// Calls `showError` of the window around `from`; does nothing without one.
void sayError(QWidget& from, const QString& sentence, MessageAct act = {});
/// Calls `say` of the window around `from`; does nothing without one.
void sayDone(QWidget& from, const QString& sentence);

}  // namespace tactus::workbench
