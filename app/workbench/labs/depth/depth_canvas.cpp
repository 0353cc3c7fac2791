#include "app/workbench/labs/depth/depth_canvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/labs/depth/depth_lab.h"
#include "app/workbench/plot/term_marks.h"

namespace tactus::workbench {
namespace {

constexpr double kReach = 9;   // px: how far from a point the mouse takes hold of it
constexpr double kOnPath = 7;  // px: a click nearer to the way adds a point between two others
constexpr double kLargestZoom = 20;
constexpr double kStepMm = 2;  // of the drawn line
constexpr double kBorder = 6;  // px around the whole image
constexpr int kNamePad = 10;   // px beside a name, on both sides together

}  // namespace

DepthCanvas::DepthCanvas(DepthLab& lab, QWidget* parent) : QWidget(parent), lab_(lab) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Image with the way of the tool"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  connect(&lab_, &DepthLab::measurementChanged, this, [this] { update(); });
}

void DepthCanvas::setImage(const QImage& image) {
  image_ = image;
  measuring_ = false;
  line_begin_.reset();
  chosen_.reset();
  held_.reset();
  zoomToAll();
}

void DepthCanvas::measureLength() {
  measuring_ = true;
  line_begin_.reset();
  setCursor(Qt::CrossCursor);
  setFocus();
  update();
}

void DepthCanvas::zoomToAll() {
  fitted_ = true;
  if (!image_.isNull()) {
    const QSizeF room = size() - QSizeF(2 * kBorder, 2 * kBorder).toSize();
    zoom_ = std::max(1e-3, std::min(room.width() / image_.width(), room.height() / image_.height()));
    origin_ = QPointF(width() - zoom_ * image_.width(), height() - zoom_ * image_.height()) / 2;
  }
  update();
}

void DepthCanvas::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (fitted_) zoomToAll();
}

QPointF DepthCanvas::onScreen(const elicitation::ImagePoint& point) const {
  return origin_ + zoom_ * QPointF(point.x, point.y);
}

elicitation::ImagePoint DepthCanvas::onImage(const QPointF& place) const {
  const QPointF point = (place - origin_) / zoom_;
  return {std::clamp(point.x(), 0.0, static_cast<double>(image_.width())),
          std::clamp(point.y(), 0.0, static_cast<double>(image_.height()))};
}

std::optional<DepthCanvas::Grip> DepthCanvas::gripAt(const QPointF& place) const {
  std::optional<Grip> best;
  double nearest = kReach;
  const auto look = [&](const Grip& grip, const elicitation::ImagePoint& point) {
    const QPointF away = onScreen(point) - place;
    const double distance = std::hypot(away.x(), away.y());
    if (distance > nearest) return;
    nearest = distance;
    best = grip;
  };
  const auto& measurement = lab_.measurement();
  for (std::size_t i = 0; i < measurement.path.size(); ++i) look({false, i}, measurement.path[i]);
  for (std::size_t k = 0; lab_.path() && k < measurement.boundaries.size(); ++k) {
    if (measurement.boundaries[k].depth_mm <= lab_.path()->lengthMm()) {
      look({true, k}, lab_.path()->at(measurement.boundaries[k].depth_mm));
    }
  }
  return best;
}

QString DepthCanvas::gripName(const Grip& grip) const {
  if (!grip.boundary) return tr("point %1 of the way").arg(grip.index + 1);
  const auto& terms = lab_.depth().terms;
  return tr("%1 | %2").arg(labelOf(terms[grip.index]), labelOf(terms[grip.index + 1]));
}

void DepthCanvas::addPoint(const QPointF& place) {
  auto wanted = lab_.measurement();
  const elicitation::ImagePoint point = onImage(place);
  std::size_t index = wanted.path.size();
  if (lab_.path()) {
    const QPointF away = onScreen(lab_.path()->at(lab_.path()->depthNear(point))) - place;
    if (std::hypot(away.x(), away.y()) < kOnPath) index = lab_.path()->gapNear(point) + 1;
  }
  wanted.path.insert(wanted.path.begin() + static_cast<std::ptrdiff_t>(index), point);
  held_ = chosen_ = Grip{false, index};
  lab_.show(wanted);
}

void DepthCanvas::move(const Grip& grip, const QPointF& place) {
  auto wanted = lab_.measurement();
  if (!grip.boundary) {
    wanted.path[grip.index] = onImage(place);
  } else if (lab_.path()) {
    // A tenth of a millimeter: what a mouse can mean.
    wanted.boundaries[grip.index].depth_mm = std::round(lab_.path()->depthNear(onImage(place)) * 10) / 10;
  }
  lab_.show(wanted);
}

void DepthCanvas::mousePressEvent(QMouseEvent* event) {
  if (image_.isNull()) return;
  mouse_ = event->position();
  if (event->button() != Qt::LeftButton) {
    pan_ = mouse_;
    setCursor(Qt::ClosedHandCursor);
    return;
  }
  if (measuring_) {
    const elicitation::ImagePoint point = onImage(mouse_);
    if (!line_begin_) {
      line_begin_ = point;
    } else {
      const elicitation::ImagePoint begin = *line_begin_;
      measuring_ = false;
      line_begin_.reset();
      unsetCursor();
      emit lineMeasured(begin, point);
    }
    update();
    return;
  }
  held_ = gripAt(mouse_);
  chosen_ = held_;
  if (!held_) addPoint(mouse_);
  update();
}

void DepthCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF before = mouse_;
  mouse_ = event->position();
  if (pan_) {
    fitted_ = false;
    origin_ += mouse_ - before;
    update();
  } else if (held_) {
    move(*held_, mouse_);
  } else if (measuring_) {
    update();
  } else {
    const auto grip = gripAt(mouse_);
    setCursor(grip ? Qt::PointingHandCursor : Qt::CrossCursor);
    setToolTip(grip ? gripName(*grip) : QString());
  }
}

void DepthCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    pan_.reset();
    unsetCursor();
    return;
  }
  if (!held_) return;
  lab_.commit(gripName(*held_));
  held_.reset();
  update();
}

void DepthCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && (measuring_ || held_)) {
    measuring_ = false;
    line_begin_.reset();
    unsetCursor();
    update();
  } else if ((event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) && chosen_ && !chosen_->boundary &&
             chosen_->index < lab_.measurement().path.size()) {
    auto wanted = lab_.measurement();
    const QString what = gripName(*chosen_);
    wanted.path.erase(wanted.path.begin() + static_cast<std::ptrdiff_t>(chosen_->index));
    chosen_.reset();
    lab_.show(wanted);
    lab_.commit(tr("%1 removed").arg(what));
  } else {
    QWidget::keyPressEvent(event);
  }
}

void DepthCanvas::wheelEvent(QWheelEvent* event) {
  if (image_.isNull()) return;
  const QPointF place = event->position();
  const double wanted = std::clamp(zoom_ * std::pow(1.0015, event->angleDelta().y()), 0.02, kLargestZoom);
  origin_ = place - (place - origin_) * (wanted / zoom_);
  zoom_ = wanted;
  fitted_ = false;
  update();
  event->accept();
}

void DepthCanvas::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.fillRect(rect(), theme::window());
  if (image_.isNull()) {
    painter.setPen(theme::mutedInk());
    painter.drawText(rect().adjusted(40, 0, -40, 0), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Load a sagittal image, or look at the example if there is one. Then click along the way, "
                        "from the entry to the end."));
    return;
  }
  painter.drawImage(QRectF(origin_, QSizeF(image_.width() * zoom_, image_.height() * zoom_)), image_);
  paintPath(painter);
  paintBoundaries(painter);
  if (line_begin_) {
    painter.setPen(QPen(theme::accent(), 2, Qt::DashLine));
    painter.drawLine(onScreen(*line_begin_), mouse_);
  }
}

void DepthCanvas::paintPath(QPainter& painter) const {
  const auto& measurement = lab_.measurement();
  if (lab_.path()) {
    QPainterPath line;
    const auto outline = lab_.path()->outline(kStepMm);
    line.moveTo(onScreen(outline.front()));
    for (const auto& point : outline) line.lineTo(onScreen(point));
    painter.setBrush(Qt::NoBrush);
    // Light around the line, so that it is seen on every image.
    painter.setPen(QPen(Qt::white, 5));
    painter.drawPath(line);
    painter.setPen(QPen(QColor(0x0B, 0x65, 0x9E), 2.4));
    painter.drawPath(line);
  }
  for (std::size_t i = 0; i < measurement.path.size(); ++i) {
    const bool chosen = chosen_ && *chosen_ == Grip{false, i};
    painter.setPen(QPen(Qt::white, 1.5));
    painter.setBrush(chosen ? QColor(0xE6, 0x9F, 0x00) : QColor(0x0B, 0x65, 0x9E));
    painter.drawEllipse(onScreen(measurement.path[i]), chosen ? 5 : 4, chosen ? 5 : 4);
  }
}

void DepthCanvas::paintBoundaries(QPainter& painter) const {
  if (!lab_.path()) return;
  const auto& measurement = lab_.measurement();
  const auto& terms = lab_.depth().terms;
  painter.setFont(theme::smallFont());
  const QFontMetrics metrics(painter.font());
  std::vector<QRectF> names;
  for (std::size_t k = 0; k < measurement.boundaries.size(); ++k) {
    const double depth_mm = measurement.boundaries[k].depth_mm;
    if (depth_mm > lab_.path()->lengthMm() || k + 1 >= terms.size()) continue;
    const QPointF place = onScreen(lab_.path()->at(depth_mm));
    painter.setPen(QPen(Qt::white, 4));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(place, 7, 7);
    painter.setPen(QPen(QColor(0xC0, 0x2B, 0x1D), 2.4));
    painter.drawEllipse(place, 7, 7);
    QString name = tr("%1 | %2  %3 mm").arg(labelOf(terms[k]), labelOf(terms[k + 1]), numberText(depth_mm, 1));
    if (metrics.horizontalAdvance(name) + kNamePad > width())
      name.replace(QStringLiteral(" | "), QStringLiteral(" |\n"));
    const QSizeF size = QSizeF(metrics.size(0, name)) + QSizeF(kNamePad, 4);
    const double middle = place.y() - size.height() / 2;
    const double around = std::clamp(place.x() - size.width() / 2, 0.0, std::max(0.0, width() - size.width()));
    // At the right of the circle, at its left, above or below: the first where it hides no other name.
    const std::array<QPointF, 4> corners = {
        QPointF(place.x() + 14, middle), QPointF(place.x() - 14 - size.width(), middle),
        QPointF(around, place.y() - 10 - size.height()), QPointF(around, place.y() + 10)};
    const auto fits = [&](const QPointF& corner) {
      const QRectF box(corner, size);
      return box.left() >= 0 && box.right() <= width() &&
             std::none_of(names.begin(), names.end(), [&box](const QRectF& one) { return one.intersects(box); });
    };
    const auto corner = std::find_if(corners.begin(), corners.end(), fits);
    const QRectF box(corner != corners.end() ? *corner : corners[2], size);
    names.push_back(box);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::card());
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(theme::ink());
    painter.drawText(box, Qt::AlignCenter, name);
  }
}

}  // namespace tactus::workbench
