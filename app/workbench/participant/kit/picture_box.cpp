#include "app/workbench/participant/kit/picture_box.h"

#include <QPainter>

namespace tactus::workbench::nurse {

PictureBox::PictureBox(const Look& look, double width_mm, double height_mm, QWidget* parent)
    : QWidget(parent), look_(look), width_mm_(width_mm), height_mm_(height_mm) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(&look, &Look::changed, this, &QWidget::updateGeometry);
}

void PictureBox::setPicture(Picture picture) {
  picture_ = std::move(picture);
  update();
}

void PictureBox::paintEvent(QPaintEvent* /*event*/) {
  if (!picture_) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  picture_(painter, QRectF(rect()).adjusted(1, 1, -1, -1));
}

}  // namespace tactus::workbench::nurse
