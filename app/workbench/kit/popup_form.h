// A small form below a button for one or two values. Escape or a click outside closes it.
#pragma once

#include <QFrame>

class QFormLayout;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class PopupForm : public QFrame {
  Q_OBJECT

 public:
  PopupForm(const QString& title, const QString& accept, QWidget* parent);

  void addField(const QString& label, QWidget* field);
  /// A sentence above the fields.
  void setNote(const QString& sentence);
  /// Shows the form below `anchor`, or above it if the space below is too small. The form is deleted when it closes.
  void openAt(const QWidget& anchor);

 signals:
  void accepted();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QLabel* note_;
  QFormLayout* fields_;
  QPushButton* accept_;
};

}  // namespace tactus::workbench
