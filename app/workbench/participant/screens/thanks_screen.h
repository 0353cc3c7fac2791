// The thanks at the end, with her own force along the way of the tool.
#pragma once

#include <QPointF>
#include <QWidget>
#include <vector>

#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

// Her own force along the way of the tool: a curve over the regions, depth in cm, no numbers for the force.

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

/// A printer is there for the curve.
bool canPrint();

/// Thank you, with her own force along the way of the tool, to print. No comparison with others.
class ThanksScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ThanksScreen(const Look& look, bool may_print = canPrint());

  void setState(const ParticipantState& state) override;

 private:
  const bool may_print_;
  Label* curve_title_;
  ForceCurve* curve_;
  Button* print_;
};

}  // namespace tactus::workbench::nurse
