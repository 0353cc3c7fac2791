// The grids of all experts side by side, and before them what their differences cost in newtons, cell by cell.
#pragma once

#include <QAbstractScrollArea>

#include "app/workbench/labs/rules/expert_grids.h"
#include "app/workbench/labs/rules/rules_lab.h"

namespace tactus::workbench {

class GridsView : public QAbstractScrollArea {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit GridsView(RulesLab& lab, QWidget* parent = nullptr);

  QSize sizeHint() const override;

 public slots:
  /// Shows what the lab has.
  void refreshState();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void layOut();
  void paintNames(QPainter& painter) const;
  void paintHeads(QPainter& painter, std::size_t block) const;
  void paintConflicts(QPainter& painter) const;
  void paintExpert(QPainter& painter, std::size_t expert) const;
  void paintChosen(QPainter& painter, std::size_t block) const;
  QString tipOf(const GridPlaces::Hit& hit) const;
  void openMenu(std::size_t expert, const GridPlace& place, const QPoint& global);
  int scrolled() const;

  RulesLab& lab_;
  GridPlaces places_;
  bool brief_ = false;     ///< the cells are too narrow for the words
  std::size_t block_ = 1;  ///< where the keyboard is
};

}  // namespace tactus::workbench
