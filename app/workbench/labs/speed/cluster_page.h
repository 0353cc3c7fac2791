// The clusters of the participants on the page (paper, Fig. 7) above the terms of all (Fig. 8 and 3d).
#pragma once

#include <QString>
#include <QWidget>
#include <memory>
#include <vector>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/labs/speed/speed_result.h"
#include "app/workbench/plot/plot_menu.h"
#include "elicitation/speed/stroke_bootstrap.h"

class QCPPainter;
class QCustomPlot;
class QLabel;

namespace tactus::workbench {

class ElidedLabel;
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
  void addHistogram(const SpeedSubject& subject);
  void addCentres(const SpeedSubject& subject, const fuzzy::Variable& speed,
                  const std::vector<elicitation::Interval>& intervals);

  ElidedLabel* title_;
  QString heading_;
  QLabel* warnings_;
  QCustomPlot* plot_;
};

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
