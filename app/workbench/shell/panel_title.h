// The title of a panel that stands alone: one slim line. It is hidden while tabs name the panel.
#pragma once

#include <QWidget>

class QDockWidget;
class QToolButton;

namespace tactus::workbench {

class ElidedLabel;

class PanelTitle : public QWidget {
  Q_OBJECT

 public:
  explicit PanelTitle(QDockWidget& panel);

  /// Whether a tab already names the panel.
  void setTabbed(bool tabbed);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

 signals:
  /// The user asks for the menu of the panel, at `place` on the screen.
  void menuRequested(const QPoint& place);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void showFloating(bool floating);

  QDockWidget& panel_;
  ElidedLabel* name_;
  QToolButton* float_;
  QToolButton* close_;
  bool tabbed_ = false;
};

}  // namespace tactus::workbench
