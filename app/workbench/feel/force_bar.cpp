#include "app/workbench/feel/force_bar.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kBarHeight = 14;  // px
constexpr int kLargeBarHeight = 30;
constexpr double kShownN = 0.0005;  // a thousandth of a newton is what the number shows

}  // namespace

ForceBar::ForceBar(QWidget* parent) : QWidget(parent), bar_height_(kBarHeight) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Force on the hand"));
}

void ForceBar::setForces(double force_n, double friction_n) {
  if (std::abs(force_n - force_n_) < kShownN && std::abs(friction_n - friction_n_) < kShownN) return;
  force_n_ = force_n;
  friction_n_ = friction_n;
  update();
}

void ForceBar::setScale(double full_n, double cap_n) {
  if (full_n == full_n_ && cap_n == cap_n_) return;
  full_n_ = full_n;
  cap_n_ = cap_n;
  update();
}

void ForceBar::setLarge(bool large) {
  bar_height_ = large ? kLargeBarHeight : kBarHeight;
  updateGeometry();
  update();
}

QSize ForceBar::sizeHint() const { return {240, bar_height_ + 4 + QFontMetrics(theme::smallFont()).height()}; }

void ForceBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF bar(0.5, 0.5, width() - 1, bar_height_ - 1);
  const auto xOf = [&](double newton) { return bar.left() + bar.width() * std::clamp(newton / full_n_, 0.0, 1.0); };
  QPainterPath frame;
  frame.addRoundedRect(bar, bar_height_ / 2.0, bar_height_ / 2.0);
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
  if (cap_n_ <= full_n_) {
    painter.setPen(QPen(theme::errorInk(), 2));
    painter.drawLine(QPointF(xOf(cap_n_), 0), QPointF(xOf(cap_n_), bar.bottom() + 3));
    painter.setPen(theme::mutedInk());
  }
  paintScale(painter, QRectF(0, bar_height_ + 4, width(), height() - bar_height_ - 4), xOf);
}

// Numbers at each half newton, and the cap at the right end; a number that has no room beside it is left out.
void ForceBar::paintScale(QPainter& painter, const QRectF& scale, const std::function<double(double)>& x_of) const {
  const QString cap = tr("cap %1").arg(quantityText(cap_n_, "N"));
  const double cap_left = scale.right() - painter.fontMetrics().horizontalAdvance(cap);
  painter.drawText(scale, Qt::AlignRight | Qt::AlignVCenter, cap);
  for (double newton = 0; newton <= full_n_ + 1e-9; newton += 0.5) {
    const QString number = numberText(newton);
    const double half = painter.fontMetrics().horizontalAdvance(number) / 2.0 + 1;
    const double x = std::clamp(x_of(newton), half, scale.width() - half);
    if (x + half > cap_left - 6) break;
    painter.drawText(QRectF(x - half, scale.top(), 2 * half, scale.height()), Qt::AlignCenter | Qt::TextDontClip,
                     number);
  }
}

}  // namespace tactus::workbench
