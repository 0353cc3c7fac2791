// The terms of the depth that follow from the boundaries (paper, Fig. 3c).
#pragma once

#include <QWidget>

#include "app/workbench/plot/plot_menu.h"
#include "core/fuzzy/force_model.h"

class QCustomPlot;

namespace tactus::workbench {

class TermLabels;

class DepthTermPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit DepthTermPlot(QWidget* parent = nullptr);

  void show(const fuzzy::Variable& depth);

  QSize pictureSize() const override { return {900, 300}; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  QCustomPlot* plot_;
  TermLabels* labels_;
};

}  // namespace tactus::workbench
