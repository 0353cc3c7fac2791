// "Serve to a simulator": starts and stops the live link, and says what a simulator needs to connect and who has.
#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace tactus::workbench {

class LinkController;
class MessageBanner;
class WrappedLabel;

/// Not modal: the model is edited while it is served.
class LinkDialog : public QDialog {
  Q_OBJECT

 public:
  explicit LinkDialog(LinkController& link, QWidget* parent = nullptr);

 private:
  void showState();
  void showFailure(const QString& sentence);

  LinkController& link_;
  QLabel* state_;
  MessageBanner* failure_;
  QPushButton* toggle_;
  QSpinBox* port_;
  QLineEdit* address_;
  QLineEdit* token_file_;
  QToolButton* copy_address_;
  QToolButton* copy_token_file_;
  QLabel* count_;
  WrappedLabel* clients_;
};

}  // namespace tactus::workbench
