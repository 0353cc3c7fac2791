// The rules as grids of force words: condition against region. The user answers with the number keys or the mouse.
#pragma once

#include <QRectF>
#include <QSize>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/tune/rules/rule_controller.h"

class QMenu;

namespace tactus::workbench {

/// The positions of the cells of the rule grids. The grids stand one above the other, below common column heads.
class RuleGridGeometry {
 public:
  struct Needs {
    std::vector<std::size_t> rows;  ///< per grid
    std::size_t columns = 0;
    double row_head = 0;  ///< px, width of the row heads
    double line = 0;      ///< px, height of a line of text
    double cell = 0;      ///< px, width for the longest word
  };

  RuleGridGeometry() = default;
  RuleGridGeometry(Needs needs, QSizeF room);

  /// The size below which the grids need scroll bars.
  static QSizeF smallest(const Needs& needs);

  QRectF cell(const RuleCell& cell) const;
  QRectF columnHead(std::size_t column) const;
  QRectF corner() const;
  QRectF title(std::size_t grid) const;
  QRectF rowHead(std::size_t grid, std::size_t row) const;
  std::optional<RuleCell> at(QPointF place) const;

 private:
  double rowTop(std::size_t grid, std::size_t row) const;

  Needs needs_;
  double width_ = 0;
  double cell_width_ = 0;
  double cell_height_ = 0;
};

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
