#include "app/workbench/plot/reading_cursor.h"

#include <QFontMetricsF>
#include <utility>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

// Over everything else, also over names that cover the line.
class ReadingCursor::Dots : public QCPLayerable {
 public:
  explicit Dots(ReadingCursor& cursor)
      : QCPLayerable(cursor.parentPlot(), QStringLiteral("overlay"), &cursor), cursor_(cursor) {
    const auto points = QStringLiteral("points");
    QCustomPlot& plot = *parentPlot();
    if (!plot.layer(points)) plot.addLayer(points, plot.layer(plot.layerCount() - 1), QCustomPlot::limAbove);
    setLayer(points);
  }

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override { painter->setAntialiasing(true); }

  void draw(QCPPainter* painter) override {
    const QCPAxisRect* area = mParentPlot->axisRect();
    if (!area->axis(QCPAxis::atBottom)->range().contains(cursor_.x_)) return;
    const double x = area->axis(QCPAxis::atBottom)->coordToPixel(cursor_.x_);
    for (const Dot& dot : cursor_.dots_) {
      painter->setPen(QPen(theme::card(), 1.5));
      painter->setBrush(theme::inLook(dot.color));
      painter->drawEllipse(QPointF(x, area->axis(QCPAxis::atLeft)->coordToPixel(dot.force_n)), 4.5, 4.5);
    }
  }

 private:
  const ReadingCursor& cursor_;
};

// The overlay is the one layer with a buffer of its own, so the cursor moves without drawing the curves again.
ReadingCursor::ReadingCursor(QCustomPlot& plot)
    : QCPLayerable(&plot, QStringLiteral("overlay")), font_(theme::smallFont()) {
  new Dots(*this);
}

void ReadingCursor::takeLook() {
  for (Dot& dot : dots_) dot.color = theme::inLook(dot.color);
}

void ReadingCursor::set(double x, QString tag, std::vector<Dot> dots) {
  x_ = x;
  tag_ = std::move(tag);
  dots_ = std::move(dots);
}

void ReadingCursor::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void ReadingCursor::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QCPRange shown = area->axis(QCPAxis::atBottom)->range();
  if (from_ && shown.contains(*from_)) {
    const double from = area->axis(QCPAxis::atBottom)->coordToPixel(*from_);
    painter->setPen(QPen(theme::accent(), 1, Qt::DashLine));
    painter->drawLine(QLineF(from, area->top(), from, area->bottom()));
  }
  if (!shown.contains(x_)) return;
  const double x = area->axis(QCPAxis::atBottom)->coordToPixel(x_);
  painter->setPen(QPen(theme::accent(), 1.2));
  painter->drawLine(QLineF(x, area->top(), x, area->bottom()));

  const QFontMetricsF metrics(font_);
  const double width = metrics.horizontalAdvance(tag_) + 12;
  const bool to_the_right = x + 6 + width <= area->right();
  const QRectF tag(to_the_right ? x + 6 : x - 6 - width, area->top() + 6.0, width, metrics.height() + 6);
  painter->setPen(Qt::NoPen);
  painter->setBrush(theme::accent());
  painter->drawRoundedRect(tag, 4, 4);
  painter->setPen(Qt::white);
  painter->setFont(font_);
  painter->drawText(QPointF(tag.left() + 6, tag.bottom() - 3 - metrics.descent()), tag_);
}

}  // namespace tactus::workbench
