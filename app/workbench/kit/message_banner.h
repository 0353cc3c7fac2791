// A message above the panels that does not block the window: what did not happen and why, the button that helps, and a
// close button.
#pragma once

#include "app/workbench/kit/card.h"
#include "app/workbench/kit/say.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace tactus::workbench {

class MessageBanner : public Card {
  Q_OBJECT

 public:
  explicit MessageBanner(QWidget* parent = nullptr);

  /// An error with a button for what helps, or two, which end the message: no error is without one. `from` can take it
  /// back.
  void showRemedy(const QString& sentence, MessageAct act, const QObject* from = nullptr, MessageAct other = {});
  /// Closes the error of `from`, if it is still shown.
  void takeBack(const QObject& from);
  void showNote(const QString& sentence);
  /// A note with a button for what can be done, or two.
  void showOffer(const QString& sentence, MessageAct act, MessageAct other = {});
  QString message() const;

 private:
  void show(const QString& sentence, const QColor& ink, const QColor& fill, MessageAct act = {}, MessageAct other = {});

  QLabel* label_;
  QPushButton* buttons_[2];
  QToolButton* close_;
  MessageAct acts_[2];             ///< of the buttons
  const QObject* from_ = nullptr;  ///< who can take the message back; only compared
};

}  // namespace tactus::workbench
