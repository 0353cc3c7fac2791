// Which of several tabs is in front, at a glance and in both looks.
#pragma once

#include <QObject>

class QTabBar;

namespace tactus::workbench {

/// Gives the tab in front the ink of the text and, in the dark look, a lighter ground; the others the ink of secondary
/// text. No line runs under them.
class TabLook : public QObject {
  Q_OBJECT

 public:
  /// Belongs to `bar`.
  explicit TabLook(QTabBar& bar);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show();

  QTabBar& bar_;
};

}  // namespace tactus::workbench
