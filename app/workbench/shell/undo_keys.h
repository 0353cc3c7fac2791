// Makes Ctrl+Z undo the model from every widget. A text field keeps the key only while the user types in it.
#pragma once

#include <QObject>

namespace tactus::workbench {

class UndoKeys : public QObject {
  Q_OBJECT

 public:
  /// Watches the text fields of the whole application.
  explicit UndoKeys(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace tactus::workbench
