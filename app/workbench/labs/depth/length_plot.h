// How far a tube reaches by each formula, over the regions of the depth and the target of the tip.
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/plot/plot_menu.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/depth/insertion_length.h"

class QCPAxisRect;
class QCustomPlot;

namespace tactus::workbench {

class LengthPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit LengthPlot(QWidget* parent = nullptr);

  /// `depth`: with its terms, between whose middles of overlap the regions are drawn.
  void show(const fuzzy::Variable& depth, const std::vector<elicitation::InsertionLength>& lengths,
            const elicitation::DepthRange& target);

  QSize pictureSize() const override { return {900, 340}; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  void addBar(double from_mm, double to_mm, double bottom, double top, const QColor& fill);
  void addText(double at_mm, double height, const QString& words, const QColor& ink, Qt::Alignment side);

  QCustomPlot* plot_;
};

/// `Nose – ear – xiphoid`, `Hanson`, `Corrected`.
QString formulaName(elicitation::LengthFormula formula);
/// Millimeters as centimeters: `49.7 cm`.
QString centimeters(double length_mm);

}  // namespace tactus::workbench
