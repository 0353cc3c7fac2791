// A message above the panels that does not block the window: what did not happen and why, the button that helps, and a
// close button.
#pragma once

#include <functional>

#include "app/workbench/kit/card.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace tactus::workbench {

/// What a message offers to do about it.
struct MessageAct {
  QString text;  ///< of the button: a verb, as in "Save elsewhere…"
  std::function<void()> run;
};

class MessageBanner : public Card {
  Q_OBJECT

 public:
  explicit MessageBanner(QWidget* parent = nullptr);

  void showError(const QString& sentence);
  /// An error with a button for what helps, which ends the message.
  void showRemedy(const QString& sentence, MessageAct act);
  void showNote(const QString& sentence);
  /// A note with a button for what can be done.
  void showOffer(const QString& sentence, MessageAct act);
  QString message() const;

 private:
  void show(const QString& sentence, const QColor& ink, const QColor& fill, MessageAct act = {});

  QLabel* label_;
  QPushButton* act_button_;
  QToolButton* close_;
  MessageAct act_;
};

}  // namespace tactus::workbench
