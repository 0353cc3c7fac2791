// The clusters of one participant (paper, Fig. 7): a histogram of the samples, the membership in each cluster, the
// centers with their 95 % intervals. The report draws the same.
#pragma once

#include <QString>
#include <QWidget>
#include <memory>
#include <vector>

#include "app/workbench/labs/speed/speed_result.h"
#include "elicitation/speed/stroke_bootstrap.h"

class QCPPainter;
class QCustomPlot;
class QLabel;

namespace tactus::workbench {

class ElidedLabel;

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

}  // namespace tactus::workbench
