// A dialog that asks for a few values.
#pragma once

#include <QDialog>
#include <QList>
#include <QPair>
#include <QString>

namespace tactus::workbench {

/// A text, a field in each row, and the buttons `act` and Cancel.
class FormDialog : public QDialog {
 public:
  using Row = QPair<QString, QWidget*>;  ///< the label, with its key, and the field

  /// The dialog takes the fields. `act`: what OK does, a verb first.
  FormDialog(const QString& title, const QString& text, const QList<Row>& rows, const QString& act, QWidget* parent);

  /// Whether the values can be accepted.
  void setReady(bool ready) { ok_->setEnabled(ready); }

 private:
  QWidget* ok_;
};

}  // namespace tactus::workbench
