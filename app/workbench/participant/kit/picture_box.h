// A small picture of its own, with its size on the screen in mm.
#pragma once

#include <QWidget>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {

class PictureBox : public QWidget {
  Q_OBJECT

 public:
  PictureBox(const Look& look, double width_mm, double height_mm, QWidget* parent = nullptr);

  void setPicture(Picture picture);

  QSize sizeHint() const override { return {look_.mm(width_mm_), look_.mm(height_mm_)}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Look& look_;
  double width_mm_;
  double height_mm_;
  Picture picture_;
};

}  // namespace tactus::workbench::nurse
