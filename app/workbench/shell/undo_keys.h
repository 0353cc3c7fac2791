// Lets Ctrl+Z undo the model wherever the keyboard is: a field takes the key for itself only while somebody types in
// it.
#pragma once

#include <QObject>

namespace tactus::workbench {

class UndoKeys : public QObject {
  Q_OBJECT

 public:
  /// Watches the fields of the whole application.
  explicit UndoKeys(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace tactus::workbench
