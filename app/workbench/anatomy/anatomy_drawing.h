// The drawing of head, throat, chest and stomach from the side, in three postures, cut to a part and kept as pixmaps.
//
// A drawing takes 10 to 26 ms, more than a frame, so the last pixmaps are kept. The tube and the lit region are drawn
// over them.
#pragma once

#include <QPainterPath>
#include <QPixmap>
#include <QRectF>
#include <QSize>
#include <deque>

#include "app/workbench/anatomy/anatomy.h"

namespace tactus::workbench::anatomy {

/// The part of the drawing to show.
enum class Framing {
  kThroat,  ///< nose to upper sphincter: as large as the first four regions can be
  kHeadAndNeck,
  kWhole,
};

/// The frame for `framing` in a picture of `size`: the part, extended on two sides to the shape of the picture, mm.
QRectF frameOf(Framing framing, Posture posture, const QSizeF& size);

/// The outline of `region`, mm.
QPainterPath outlineOf(Region region, Posture posture);

class AnatomyDrawing {
 public:
  /// The drawing without tube, `size` logical px, at `ratio` device pixels each.
  QPixmap pixmap(Posture posture, Framing framing, const QSize& size, double ratio);

 private:
  struct Kept {
    Posture posture;
    Framing framing;
    QSize size;
    double ratio;
    QPixmap pixmap;
  };
  std::deque<Kept> kept_;  ///< newest first
};

}  // namespace tactus::workbench::anatomy
