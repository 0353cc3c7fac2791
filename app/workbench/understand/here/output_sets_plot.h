// The output sets of the rules, their aggregation, and its centroid, which is the force.
#pragma once

#include <QWidget>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/plot/plot_menu.h"
#include "core/analysis/explain.h"
#include "core/fuzzy/force_model.h"

class QCustomPlot;

namespace tactus::workbench {

class ReadingCursor;

class OutputSetsPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit OutputSetsPlot(QWidget* parent = nullptr);

  /// Shows the sets of one expert in the colors of their terms.
  void showExpert(const fuzzy::ForceModel& model, const analysis::Explanation& explanation, std::size_t expert);
  /// Shows one set per expert in the color of the expert, and the mean.
  void showExperts(const fuzzy::ForceModel& model, const analysis::Explanation& explanation);

  /// The corners of the drawn sets: set, force, height.
  void fillTable(PlotTable& table) const;
  QSize pictureSize() const override { return {800, 420}; }
  std::vector<LegendEntry> legend() const override;
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  void begin(const fuzzy::Variable& output);
  void addSet(const QString& name, const analysis::Polyline& set, const QColor& color, float fill_alpha, double width);
  void finish(bool fired, double force_n, const QString& tag);

  QCustomPlot* plot_;
  fuzzy::Variable output_;
  ReadingCursor* cursor_;
};

}  // namespace tactus::workbench
