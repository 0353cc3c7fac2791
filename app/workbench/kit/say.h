// Messages from a view to the user, wherever the view is in the window.
#pragma once

#include <QString>

#include "app/workbench/base/message_act.h"

class QObject;
class QWidget;

namespace tactus::workbench {

/// A window that shows messages. Views reach the window around them with `sayError` and `sayDone`.
class MessagePlace {
 public:
  virtual ~MessagePlace() = default;
  /// What did not happen, and why, with a button for what helps. The message stays until the user closes it or `from`
  /// takes it back.
  virtual void showError(const QString& sentence, MessageAct act, const QObject& from) = 0;
  /// Closes the error of `from`, if it is still shown.
  virtual void takeBackError(const QObject& from) = 0;
  /// A completed action. The strip shows it for some seconds.
  virtual void say(const QString& sentence) = 0;
};

/// Calls `showError` of the window around `from`; does nothing without one.
void sayError(QWidget& from, const QString& sentence, MessageAct act = {});
/// `from` succeeded or tries anew: its error is out of date. Does nothing without a window around it.
void takeBackError(QWidget& from);
/// Calls `say` of the window around `from`, whose error ends with it; does nothing without one.
void sayDone(QWidget& from, const QString& sentence);

}  // namespace tactus::workbench
