#include "app/workbench/participant/kit/dots.h"

#include <QPainter>

#include "app/workbench/participant/kit/colors.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kDotMm = 8;
constexpr double kGapMm = 3;

}  // namespace

Dots::Dots(const Look& look, QWidget* parent) : QWidget(parent), look_(look) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(&look, &Look::changed, this, &Dots::follow);
}

void Dots::setCount(int filled, int all) {
  if (filled == filled_ && all == all_) return;
  filled_ = filled;
  all_ = all;
  follow();
}

void Dots::follow() {
  setAccessibleName(
      look_.say(phrase(QStringLiteral("acc.recorded"), {QString::number(filled_), QString::number(all_)})));
  updateGeometry();
  update();
}

QSize Dots::sizeHint() const {
  if (all_ == 0) return {0, 0};
  return {all_ * look_.mm(kDotMm) + (all_ - 1) * look_.mm(kGapMm), look_.mm(kDotMm)};
}

void Dots::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double dot = look_.mm(kDotMm);
  for (int i = 0; i < all_; ++i) {
    const QRectF box(i * (dot + look_.mm(kGapMm)), 0, dot, dot);
    const bool filled = i < filled_;
    painter.setPen(QPen(filled ? colors::kAccent : colors::kEdge, 2.5));
    painter.setBrush(filled ? colors::kAccent : colors::kCard);
    painter.drawEllipse(box.adjusted(1.5, 1.5, -1.5, -1.5));
    if (!filled) continue;
    painter.setPen(Qt::white);
    drawTick(painter, box, dot / 9);
  }
}

}  // namespace tactus::workbench::nurse
