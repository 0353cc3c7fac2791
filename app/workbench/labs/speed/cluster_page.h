// The clusters of the participants on the page (paper, Fig. 7) above the terms of all (Fig. 8 and 3d).
#pragma once

#include <QString>
#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/labs/speed/speed_clusters.h"
#include "app/workbench/plot/chart.h"
#include "app/workbench/plot/plot_menu.h"
#include "elicitation/speed/stroke_bootstrap.h"

class QCPPainter;
class QLabel;

namespace tactus::workbench {

// The speed terms (paper, Fig. 8 and 3d): the ramps of each participant and the trapezoids averaged from them, with the
// 95 % intervals of their corners. The report draws the same.

class TermLabels;
class VertexPick;

class SpeedTermPlot : public ChartView {
  Q_OBJECT

 public:
  explicit SpeedTermPlot(QWidget* parent = nullptr);

  /// `former`: the terms of the model before the last change of the settings, dashed; empty: none. Returns whether one
  /// of them is another.
  bool setTerms(const SpeedResult& result, const std::vector<fuzzy::Term>& former);
  VertexPick& corners() { return *corners_; }

 signals:
  /// The user clicked a corner of the averaged terms.
  void vertexAsked(const std::string& term, std::size_t point);

 private:
  TermLabels* labels_;
  VertexPick* corners_;
};

class ElidedLabel;
class SettingsPrice;
class SpeedLab;
class SpeedTermPlot;

// The clusters of one participant (paper, Fig. 7): a histogram of the samples, the membership in each cluster, the
// centers with their 95 % intervals. The report draws the same.

class ClusterPlot : public QWidget {
  Q_OBJECT

 public:
  explicit ClusterPlot(QWidget* parent = nullptr);

  /// `number`: of the participant's color. `intervals`: of the centers; empty while they are computed.
  void show(const SpeedSubject& subject, const fuzzy::Variable& speed, std::size_t number,
            const std::vector<elicitation::Interval>& intervals);
  /// Draws the plot over `size` px at the origin of `painter`.
  void paint(QCPPainter& painter, const QSize& size);

 private:
  ElidedLabel* title_;
  QString heading_;
  QLabel* warnings_;
  ChartView* chart_;
};

class ClusterPage : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  /// Both outlive this.
  ClusterPage(SpeedLab& lab, const SettingsPrice& price, QWidget* parent = nullptr);

  QSize pictureSize() const override { return {940, 620}; }
  SpeedTermPlot& terms() { return *terms_; }
  /// The clusters on the page.
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  QWidget* makeTerms();
  void refreshState();
  PlotTable clusterTable() const;
  PlotTable termTable() const;
  QString settingText() const;

  SpeedLab& lab_;
  const SettingsPrice& price_;
  std::vector<ClusterPlot*> plots_;
  SpeedTermPlot* terms_;
  ElidedLabel* key_;
  QLabel* said_;
  QLabel* waiting_;
};

}  // namespace tactus::workbench
