// The live link in stage Deliver: whether the model is served, to whom, and the way to its panel.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace tactus::workbench {

class LinkController;

class LinkRow : public QWidget {
  Q_OBJECT

 public:
  explicit LinkRow(const LinkController& link, QWidget* parent = nullptr);

 signals:
  /// The user wants the panel of the link.
  void asked();

 private:
  void showState();

  const LinkController& link_;
  QLabel* state_;
  QPushButton* open_;
};

}  // namespace tactus::workbench
