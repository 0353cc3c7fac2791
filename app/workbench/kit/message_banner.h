// A message above the panels that does not block the window: one sentence and a close button.
#pragma once

#include "app/workbench/kit/card.h"

class QLabel;
class QToolButton;

namespace tactus::workbench {

class MessageBanner : public Card {
  Q_OBJECT

 public:
  explicit MessageBanner(QWidget* parent = nullptr);

  void showError(const QString& sentence);
  void showNote(const QString& sentence);
  QString message() const;

 private:
  void show(const QString& sentence, const QColor& ink, const QColor& fill);

  QLabel* label_;
  QToolButton* close_;
};

}  // namespace tactus::workbench
