#include "app/workbench/anatomy/inset_view.h"

#include <QPainter>
#include <QPainterPath>
#include <QSvgRenderer>
#include <string_view>

#include "app/workbench/base/theme.h"

namespace tactus::workbench::anatomy {

std::string_view frontDrawing();
std::string_view behindDrawing();

namespace {

QPixmap drawn(Inset inset, const QSize& size, double ratio) {
  const std::string_view file = inset == Inset::kFront ? frontDrawing() : behindDrawing();
  QPixmap pixmap(size * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(theme::card());
  QSvgRenderer renderer(QByteArray::fromRawData(file.data(), static_cast<qsizetype>(file.size())));
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

InsetView::InsetView(Inset inset, QWidget* parent) : QWidget(parent), inset_(inset) {}

void InsetView::paintEvent(QPaintEvent* /*event*/) {
  if (width() < 2 || height() < 2) return;
  const double ratio = devicePixelRatioF();
  if (drawing_.size() != size() * ratio) drawing_ = drawn(inset_, size(), ratio);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath corners;
  corners.addRoundedRect(rect(), theme::kCornerRadius, theme::kCornerRadius);
  painter.setClipPath(corners);
  painter.drawPixmap(0, 0, drawing_);
}

}  // namespace tactus::workbench::anatomy
