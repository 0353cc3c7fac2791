// Zoom and pan of a plot over inputs: the wheel zooms around the mouse, Shift and drag moves, a double click shows all.
// The context menu has the same and the presets.
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>
#include <vector>

#include "core/fuzzy/force_model.h"

class QCustomPlot;
class QMenu;
class QPoint;

namespace tactus::workbench {

class ShownRanges;

class AxisZoom : public QObject {
  Q_OBJECT

 public:
  /// Belongs to `plot`, and changes `ranges` only; the plot shows them after `changed`.
  AxisZoom(QCustomPlot& plot, ShownRanges& ranges);

  /// The input of the x axis, and that of the y axis if it has one.
  void setInputs(const fuzzy::Variable& x, const std::optional<fuzzy::Variable>& y = std::nullopt);
  /// Gives the axes the ranges that are shown.
  void apply();

 signals:
  /// The menu opens for `place` on the plot, px: the plot may add to it.
  void menuOpens(QMenu* menu, QPointF place);
  /// The range of an input on an axis changed.
  void changed();
  /// A click with Shift, without a drag.
  void shiftClicked(QPointF place);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Axis {
    fuzzy::Variable input;
    bool across = true;  ///< the x axis
  };
  double valueAt(const Axis& axis, QPointF place) const;
  void zoom(QPointF around, double factor);
  void pan(QPointF from, QPointF to);
  void showAll();
  void openMenu(const QPoint& global, QPointF place);

  QCustomPlot& plot_;
  ShownRanges& ranges_;
  std::vector<Axis> axes_;
  std::optional<QPointF> dragged_from_;
  bool moved_ = false;  ///< since the press
};

}  // namespace tactus::workbench
