// A small plot of one variable's membership functions: filled shapes with their names, and a marker at the current
// value.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/plot/plot_menu.h"
#include "core/fuzzy/force_model.h"

class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

class TermLabels;
class ValueMarker;

class MembershipPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit MembershipPlot(const fuzzy::Variable& variable, QWidget* parent = nullptr);

  /// The terms to draw, over the universe of the variable.
  void setTerms(const std::vector<fuzzy::Term>& terms);
  /// The value of the marker; nothing: no marker.
  void setValue(std::optional<double> value);

  /// The corners of the terms as they are drawn.
  void fillTable(PlotTable& table) const;
  QSize pictureSize() const override { return {800, 360}; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

  // Margins to the left and right of the axis, px. Other widgets use them to align with the axis.
  static constexpr int kLeftMargin = 24;
  static constexpr int kRightMargin = 16;

 signals:
  /// The mouse was pressed or dragged at `value`, in the unit of the variable.
  void picked(double value);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void onMouse(QMouseEvent* event);
  void updateMarker();

  fuzzy::Variable variable_;
  std::vector<fuzzy::Term> terms_;
  std::optional<double> value_;
  QCustomPlot* plot_;
  TermLabels* labels_;
  ValueMarker* marker_;
};

}  // namespace tactus::workbench
