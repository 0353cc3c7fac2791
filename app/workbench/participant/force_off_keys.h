// Esc means "Force off" in the whole program: in any window, whatever has the keyboard.
#pragma once

#include <QObject>

namespace tactus::workbench {

class ForceOffKeys : public QObject {
  Q_OBJECT

 public:
  explicit ForceOffKeys(QObject* parent = nullptr);

  /// Watches the keys of the whole program, or stops. While it watches, nothing else gets Esc.
  void setOn(bool on);

 signals:
  /// Esc went down. A held key asks once.
  void pressed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool on_ = false;
};

}  // namespace tactus::workbench
