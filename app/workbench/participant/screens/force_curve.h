// Her own force along the way of the tube: a curve over the five regions, depth in cm, no numbers for the force.
#pragma once

#include <QPointF>
#include <QWidget>
#include <vector>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

class ForceCurve : public QWidget {
  Q_OBJECT

 public:
  explicit ForceCurve(const Look& look, QWidget* parent = nullptr);

  /// Points of depth in mm and force as a share of the largest one, [0, 1].
  void setCurve(std::vector<QPointF> points);
  /// Draws the curve into `area`, on the screen or on paper, in the font of `painter`.
  void draw(QPainter& painter, const QRectF& area) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Look& look_;
  std::vector<QPointF> points_;
};

}  // namespace tactus::workbench::nurse
