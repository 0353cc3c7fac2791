#include <QPainter>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/feel/duel/duel_window.h"

namespace tactus::workbench {
namespace {

constexpr int kPaceHeight = 14;  // px

}  // namespace

PaceBar::PaceBar(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("The way of the tip and the prompted speed"));
}

void PaceBar::setWay(double from_mm, double to_mm) {
  from_mm_ = from_mm;
  to_mm_ = to_mm;
  update();
}

void PaceBar::setPlaces(std::optional<double> tip_mm, std::optional<double> prompt_mm) {
  if (tip_mm == tip_mm_ && prompt_mm == prompt_mm_) return;
  tip_mm_ = tip_mm;
  prompt_mm_ = prompt_mm;
  update();
}

QSize PaceBar::sizeHint() const { return {320, kPaceHeight + 2 * theme::kGrid}; }

void PaceBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF bar(1, (height() - kPaceHeight) / 2.0, width() - 2, kPaceHeight);
  painter.setPen(theme::border());
  painter.setBrush(theme::card());
  painter.drawRoundedRect(bar, 4, 4);
  const auto x_of = [&](double mm) {
    return bar.left() + bar.width() * std::clamp((mm - from_mm_) / (to_mm_ - from_mm_), 0.0, 1.0);
  };
  if (tip_mm_) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::accent());
    painter.drawRoundedRect(QRectF(bar.topLeft(), QPointF(x_of(*tip_mm_), bar.bottom())), 4, 4);
  }
  if (prompt_mm_) {
    painter.setPen(QPen(theme::ink(), 2));
    const double x = x_of(*prompt_mm_);
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
  }
}

}  // namespace tactus::workbench
