#include "app/workbench/feel/force_bar.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kBarHeight = 14;      // px
constexpr double kShownN = 0.0005;  // a thousandth of a newton is what the number shows

}  // namespace

ForceBar::ForceBar(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Force on the hand"));
}

void ForceBar::setForces(double force_n, double friction_n) {
  if (std::abs(force_n - force_n_) < kShownN && std::abs(friction_n - friction_n_) < kShownN) return;
  force_n_ = force_n;
  friction_n_ = friction_n;
  update();
}

void ForceBar::setFullScale(double full_n) {
  full_n_ = full_n;
  update();
}

QSize ForceBar::sizeHint() const { return {240, kBarHeight + 4 + QFontMetrics(theme::smallFont()).height()}; }

void ForceBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF bar(0.5, 0.5, width() - 1, kBarHeight - 1);
  const auto xOf = [&](double newton) { return bar.left() + bar.width() * std::clamp(newton / full_n_, 0.0, 1.0); };
  QPainterPath frame;
  frame.addRoundedRect(bar, kBarHeight / 2.0, kBarHeight / 2.0);
  painter.fillPath(frame, theme::grid());
  painter.save();
  painter.setClipPath(frame);
  // A resistance against withdrawal fills the bar in another color.
  const double shown_n = std::abs(force_n_);
  painter.fillRect(QRectF(bar.topLeft(), QPointF(xOf(shown_n), bar.bottom())),
                   force_n_ >= 0 ? theme::accent() : theme::mutedInk());
  if (std::abs(friction_n_) > shown_n + kShownN)
    painter.fillRect(QRectF(QPointF(xOf(shown_n), bar.top()), QPointF(xOf(std::abs(friction_n_)), bar.bottom())),
                     QBrush(theme::warningInk(), Qt::BDiagPattern));
  painter.restore();
  painter.setPen(QPen(theme::border(), 1));
  painter.drawPath(frame);

  painter.setFont(theme::smallFont());
  painter.setPen(theme::mutedInk());
  const QRectF scale(0, kBarHeight + 4, width(), height() - kBarHeight - 4);
  for (double newton = 0; newton <= full_n_ + 1e-9; newton += 0.5) {
    const bool last = newton > full_n_ - 0.5 + 1e-9;
    const QString number = last ? quantityText(newton, "N") : numberText(newton);
    const double half = painter.fontMetrics().horizontalAdvance(number) / 2.0 + 1;
    const double x = std::clamp(xOf(newton), half, width() - half);
    painter.drawText(QRectF(x - half, scale.top(), 2 * half, scale.height()), Qt::AlignCenter | Qt::TextDontClip,
                     number);
  }
}

}  // namespace tactus::workbench
