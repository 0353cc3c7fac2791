// The clusters of the participants on the page (paper, Fig. 7) above the terms of all (Fig. 8 and 3d).
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/plot/plot_menu.h"

class QLabel;

namespace tactus::workbench {

class ClusterPlot;
class ElidedLabel;
class SpeedLab;
class SpeedTermPlot;

class ClusterPage : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit ClusterPage(SpeedLab& lab, QWidget* parent = nullptr);

  QSize pictureSize() const override { return {940, 620}; }
  SpeedTermPlot& terms() { return *terms_; }
  /// The clusters on the page.
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  QWidget* makeTerms();
  void follow();
  PlotTable clusterTable() const;
  PlotTable termTable() const;
  QString settingText() const;

  SpeedLab& lab_;
  std::vector<ClusterPlot*> plots_;
  SpeedTermPlot* terms_;
  ElidedLabel* key_;
  QLabel* said_;
  QLabel* waiting_;
};

}  // namespace tactus::workbench
