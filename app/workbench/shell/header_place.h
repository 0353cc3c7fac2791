// Where the line of the open model stands: above the panels, or, in a low window, in the row of the menus.
#pragma once

#include <QObject>

class QMenuBar;

namespace tactus::workbench {

class BenchView;

class HeaderPlace : public QObject {
  Q_OBJECT

 public:
  /// `bench` owns the line while it stands above the panels, `menus` while it stands beside them.
  HeaderPlace(QMenuBar& menus, BenchView& bench, QObject* parent);

  /// True: beside the menus. A menu bar outside the window has no room for it.
  void setLow(bool low);
  /// Whether the panels are on the screen. While the window shows another screen, a line beside the menus is hidden.
  void setShown(bool shown);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();

  QMenuBar& menus_;
  BenchView& bench_;
  bool low_ = false;
  bool shown_ = false;
};

}  // namespace tactus::workbench
