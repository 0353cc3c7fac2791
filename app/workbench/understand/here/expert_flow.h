// How the forces of the experts lead to the mean: one line per expert with the set of its rules, the centroid of the
// set, and the expert's share in the mean.
#pragma once

#include <QWidget>
#include <memory>

#include "app/workbench/model/open_model.h"
#include "core/analysis/explain.h"

namespace tactus::workbench {

class ExpertFlow : public QWidget {
  Q_OBJECT

 public:
  explicit ExpertFlow(QWidget* parent = nullptr);

  void set(std::shared_ptr<const OpenModel> open, analysis::Explanation explanation);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// The user clicked the line of `expert`.
  void chosen(std::size_t expert);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void paintLine(QPainter& painter, std::size_t expert) const;
  QString strongestRule(std::size_t expert) const;

  std::shared_ptr<const OpenModel> open_;
  analysis::Explanation explanation_;
};

}  // namespace tactus::workbench
