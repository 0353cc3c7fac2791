// The guide beside the program: its pages on the left, the page that is read on the right.
#pragma once

#include <QWidget>

class QListWidget;

namespace tactus::workbench {

class GuideBrowser;

class GuideWindow : public QWidget {
  Q_OBJECT

 public:
  explicit GuideWindow(QWidget* parent = nullptr);

  /// Shows the window before others.
  void open();
  GuideBrowser& browser() { return *browser_; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QListWidget* pages_;
  GuideBrowser* browser_;
};

}  // namespace tactus::workbench
