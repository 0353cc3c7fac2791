#include <QPainter>
#include <QPainterPath>
#include <QSvgRenderer>
#include <utility>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench::anatomy {

namespace {

QPixmap drawn(const QByteArray& svg, const QSize& size, double ratio) {
  QPixmap pixmap(size * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(theme::card());
  QSvgRenderer renderer(svg);
  const QSizeF room = renderer.viewBoxF().size().scaled(QSizeF(size), Qt::KeepAspectRatio);
  QRectF place(QPointF(), room);
  place.moveCenter(QRectF(QPointF(), QSizeF(size)).center());
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(place);  // QSvgRenderer draws beyond its target
  renderer.render(&painter, place);
  return pixmap;
}

}  // namespace

InsetView::InsetView(QByteArray svg, QWidget* parent) : QWidget(parent), svg_(std::move(svg)) {}

void InsetView::paintEvent(QPaintEvent* /*event*/) {
  if (width() < 2 || height() < 2) return;
  const double ratio = devicePixelRatioF();
  if (drawing_.size() != size() * ratio) drawing_ = drawn(svg_, size(), ratio);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath corners;
  corners.addRoundedRect(rect(), theme::kCornerRadius, theme::kCornerRadius);
  painter.setClipPath(corners);
  painter.drawPixmap(0, 0, drawing_);
}

}  // namespace tactus::workbench::anatomy
