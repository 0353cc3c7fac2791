// Makes the current tab easy to see in both looks.
#pragma once

#include <QObject>

class QTabBar;

namespace tactus::workbench {

/// The current tab has the normal text color and, in the dark look, a lighter background. The other tabs have the color
/// of secondary text. No line is drawn below the tabs.
class TabLook : public QObject {
  Q_OBJECT

 public:
  /// `bar` owns this object.
  explicit TabLook(QTabBar& bar);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show();

  QTabBar& bar_;
};

}  // namespace tactus::workbench
