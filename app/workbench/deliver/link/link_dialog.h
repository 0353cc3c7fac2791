// "Serve to a simulator": starts and stops the live link, and says what a simulator needs to connect and who has.
#pragma once

#include <QDialog>
#include <QString>
#include <QToolButton>
#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace tactus::workbench {

class LinkController;
class MessageBanner;
class WrappedLabel;

// The sign in the strip while the live link serves: address and number of clients. A click asks for its panel.

/// Hidden while nothing is served.
class LinkSign : public QToolButton {
  Q_OBJECT

 public:
  explicit LinkSign(const LinkController& link, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  /// Room for the short text.
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showState();
  void fit();
  QSize sizeFor(const QString& text) const;

  const LinkController& link_;
  QString full_;
  QString brief_;
};

// The live link in stage Deliver: whether the model is served, to whom, and the way to its panel.

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

// How the state of the live link reads on the screen.

/// `Serving 127.0.0.1:45123 · 2 connected`; empty while nothing is served.
QString servingText(const LinkController& link);
/// The same for a narrow place: `Serving · 2`.
QString shortServingText(const LinkController& link);
/// Who is connected: `2 connected`, `none connected`, `the last left at 14:32`.
QString connectedText(const LinkController& link);

/// Not modal: the model is edited while it is served.
class LinkDialog : public QDialog {
  Q_OBJECT

 public:
  explicit LinkDialog(LinkController& link, QWidget* parent = nullptr);

  /// Shows it in front of the other windows.
  void bringUp();

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
