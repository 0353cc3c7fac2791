// The rules as grids of force words: condition against region. The user answers with the number keys or the mouse.
#pragma once

#include <QWidget>
#include <optional>

#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_grid_geometry.h"

class QMenu;

namespace tactus::workbench {

class Flash;

class RuleGrids : public QWidget {
  Q_OBJECT

 public:
  explicit RuleGrids(RuleController& rules, QWidget* parent = nullptr);

  QSize sizeHint() const override { return minimumSizeHint(); }
  QSize minimumSizeHint() const override;
  /// The rectangle of a cell, in the coordinates of the widget.
  QRect cellRect(const RuleCell& cell) const { return places().cell(cell).toRect(); }
  /// A menu of the words for the selected cell.
  QMenu* makeMenu();

 public slots:
  /// Shows the current rules.
  void showRules();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void measureAnew();
  RuleGridGeometry::Needs measured() const;
  const RuleGridGeometry::Needs& needs() const;
  const RuleGridGeometry& places() const;
  bool answerKey(int key);
  bool moveKey(int key);
  void paintHeads(QPainter& painter) const;
  void paintGrid(QPainter& painter, std::size_t grid) const;
  void paintCell(QPainter& painter, const RuleCell& place) const;
  void paintSelection(QPainter& painter) const;
  QString tipOf(const RuleCell& cell) const;

  RuleController& rules_;
  Flash* flash_;
  // For the current rules; computed on demand.
  mutable std::optional<RuleGridGeometry::Needs> needs_;
  mutable std::optional<RuleGridGeometry> geometry_;
};

}  // namespace tactus::workbench
