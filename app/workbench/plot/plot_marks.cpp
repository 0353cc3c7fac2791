#include "app/workbench/plot/plot_marks.h"

#include <QFontMetricsF>
#include <QMouseEvent>
#include <cmath>
#include <qcustomplot.h>
#include <utility>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr double kReachPx = 10;

}  // namespace

VertexPick::VertexPick(QCustomPlot& plot, const QString& what) : QObject(&plot), plot_(plot), what_(what) {
  plot_.setMouseTracking(true);
  connect(&plot_, &QCustomPlot::mouseMove, this, &VertexPick::onMove);
  connect(&plot_, &QCustomPlot::mouseRelease, this, &VertexPick::onRelease);
}

QPointF VertexPick::pixelOf(const Vertex& vertex) const {
  return {plot_.xAxis->coordToPixel(vertex.x), plot_.yAxis->coordToPixel(vertex.membership)};
}

std::optional<std::size_t> VertexPick::at(const QPointF& place) const {
  std::optional<std::size_t> best;
  double nearest = kReachPx;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const QPointF away = pixelOf(vertices_[i]) - place;
    const double distance = std::hypot(away.x(), away.y());
    if (distance >= nearest) continue;
    nearest = distance;
    best = i;
  }
  return best;
}

void VertexPick::onMove(QMouseEvent* event) {
  const bool there = at(event->position()).has_value();
  plot_.setCursor(there ? Qt::PointingHandCursor : Qt::ArrowCursor);
  plot_.setToolTip(there ? what_ : QString());
}

void VertexPick::onRelease(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (const auto found = at(event->position())) emit picked(vertices_[*found].term, vertices_[*found].point);
}

// The overlay has a buffer of its own, so the marker moves without drawing the shapes again.
ValueMarker::ValueMarker(QCustomPlot& plot) : QCPLayerable(&plot, QStringLiteral("overlay")) {}

void ValueMarker::set(std::optional<double> value, std::vector<double> memberships) {
  value_ = value;
  memberships_ = std::move(memberships);
}

void ValueMarker::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void ValueMarker::draw(QCPPainter* painter) {
  if (!value_) return;
  const QCPAxisRect* area = mParentPlot->axisRect();
  if (!area->axis(QCPAxis::atBottom)->range().contains(*value_)) return;
  const double x = area->axis(QCPAxis::atBottom)->coordToPixel(*value_);
  painter->setPen(QPen(theme::accent(), 1.4));
  painter->drawLine(QLineF(x, area->top(), x, area->bottom()));
  painter->setPen(QPen(theme::card(), 1.2));
  painter->setBrush(theme::accent());
  for (const double membership : memberships_) {
    painter->drawEllipse(QPointF(x, area->axis(QCPAxis::atLeft)->coordToPixel(membership)), 4, 4);
  }
}

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
