#include "app/workbench/feel/sagittal_view.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/feel/sagittal_drawing.h"

namespace tactus::workbench {
namespace {

constexpr double kStepMm = 4;  // of the lines along the passage
constexpr int kGestureMs = 1000;
constexpr double kDrawnMm = 0.2;    // less than a pixel
constexpr double kOutsideMm = -60;  // what of the tube is drawn in front of the nose
constexpr double kLeader = 14;      // px from the picture to the names
// More than this share of the widget is not for names; longer ones end in an ellipsis.
constexpr double kLabelShare = 0.55;

// The same hues in both looks.
QColor skin() { return theme::isDark() ? QColor(0x35, 0x30, 0x2D) : QColor(0xF7, 0xF1, 0xEC); }
QColor passage() { return theme::isDark() ? QColor(0x5C, 0x45, 0x3E) : QColor(0xEB, 0xD3, 0xCB); }

}  // namespace

SagittalView::SagittalView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Schematic of the way of the tube"));
  turn_.setDuration(kGestureMs);
  turn_.setEasingCurve(QEasingCurve::InOutSine);
  connect(&turn_, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
    flexion_ = value.toDouble();
    update();
  });
}

void SagittalView::setRegions(std::vector<DepthRegion> regions) {
  regions_ = std::move(regions);
  update();
}

void SagittalView::setDepth(double depth_mm) {
  if (std::abs(depth_mm - depth_mm_) < kDrawnMm) return;
  depth_mm_ = depth_mm;
  update();
}

QString SagittalView::regionText() const {
  const auto region = litRegion();
  return region ? regions_[*region].label : QString();
}

std::optional<std::size_t> SagittalView::litRegion() const {
  return depth_mm_ > 0 ? regionAt(regions_, depth_mm_) : std::nullopt;
}

void SagittalView::setNeckFlexed(bool flexed) {
  if (flexed_ == flexed) return;
  const bool first = !flexed_;
  flexed_ = flexed;
  turn_.stop();
  if (first || !isVisible()) {
    flexion_ = flexed ? 1 : 0;
    update();
    return;
  }
  turn_.setStartValue(flexion_);
  turn_.setEndValue(flexed ? 1.0 : 0.0);
  turn_.start();
}

void SagittalView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(theme::smallFont());
  const double line = painter.fontMetrics().height();
  const QString caption = tr("Schematic, not to scale");
  const double picture_height = height() - line - 4;

  const double room = std::min(labelWidth() + kLeader, width() * kLabelShare);
  const double scale = std::min((width() - room) / sagittal::kWidth, picture_height / sagittal::kHeight);
  QTransform to_widget;
  to_widget.translate(0, (picture_height - scale * sagittal::kHeight) / 2);
  to_widget.scale(scale, scale);

  painter.save();
  painter.setTransform(to_widget, true);
  painter.setClipRect(QRectF(0, 0, sagittal::kWidth, sagittal::kHeight));
  painter.setPen(QPen(theme::border().darker(108), 1.5 / scale));
  painter.setBrush(skin());
  painter.drawPath(sagittal::outline(flexion_));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(passage().darker(104), 7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setOpacity(0.5);
  painter.drawPath(sagittal::airway(flexion_));
  painter.setOpacity(1);
  painter.setPen(QPen(passage().darker(112), 1.5 / scale));
  painter.setBrush(passage());
  painter.drawPath(sagittal::stomach(flexion_));
  const auto lit = litRegion();
  drawPassage(painter, 0, sagittal::endMm(), passage());
  QColor light = theme::accent();
  light.setAlpha(110);
  if (lit) drawPassage(painter, regions_[*lit].from_mm, regions_[*lit].to_mm, light);
  // The boundaries between the regions.
  painter.setPen(QPen(skin(), 2 / scale));
  for (std::size_t i = 1; i < regions_.size(); ++i) {
    const double mm = regions_[i].from_mm;
    const QPointF at = sagittal::placeAt(mm, flexion_);
    const QPointF way = sagittal::placeAt(mm + 2, flexion_) - sagittal::placeAt(mm - 2, flexion_);
    const QPointF across = QPointF(-way.y(), way.x()) / std::hypot(way.x(), way.y()) * sagittal::widthAt(mm) / 2;
    painter.drawLine(at - across, at + across);
  }
  drawTube(painter);
  painter.restore();

  const double text_x = scale * sagittal::kWidth + kLeader;
  for (const Label& label : labels(to_widget, line, 2, picture_height)) {
    painter.setPen(QPen(label.lit ? theme::accent() : theme::border().darker(115), 1));
    painter.drawLine(QPointF(text_x - 2, label.y), QPointF(text_x - 12, label.y));
    painter.drawLine(QPointF(text_x - 12, label.y), label.at);
    QFont font = theme::smallFont();
    font.setBold(label.lit);
    painter.setFont(font);
    painter.setPen(label.lit ? theme::accent() : theme::mutedInk());
    const double text_room = width() - text_x;
    painter.drawText(QRectF(text_x, label.y - line / 2, text_room, line), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(label.text, Qt::ElideRight, static_cast<int>(text_room)));
  }
  painter.setFont(theme::smallFont());
  painter.setPen(theme::mutedInk());
  painter.drawText(QRectF(0, height() - line, width(), line), Qt::AlignLeft | Qt::AlignVCenter, caption);
}

double SagittalView::labelWidth() const {
  QFont lit = theme::smallFont();
  lit.setBold(true);
  const QFontMetricsF metrics(lit);
  double widest = 0;
  for (const DepthRegion& region : regions_) widest = std::max(widest, metrics.horizontalAdvance(region.label) + 4);
  return widest;
}

std::vector<SagittalView::Label> SagittalView::labels(const QTransform& to_widget, double line, double top,
                                                      double bottom) const {
  std::vector<Label> out;
  const auto lit = litRegion();
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    const DepthRegion& region = regions_[i];
    const double middle = (region.from_mm + std::min(region.to_mm, sagittal::endMm())) / 2;
    const QPointF at = to_widget.map(sagittal::placeAt(middle, flexion_));
    out.push_back({at, at.y(), region.label, lit == i});
  }
  // In the order of the way; a name that would print over the one before moves down, and all move up at the end.
  double free_y = top + line / 2;
  for (Label& label : out) {
    label.y = std::max(label.y, free_y);
    free_y = label.y + line + 2;
  }
  double last_y = bottom - line / 2;
  for (auto label = out.rbegin(); label != out.rend(); ++label) {
    label->y = std::min(label->y, last_y);
    last_y = label->y - line - 2;
  }
  return out;
}

void SagittalView::drawPassage(QPainter& painter, double from_mm, double to_mm, const QColor& color) const {
  // One shape, so that a translucent color does not show its pieces.
  QPainterPath left;
  QPainterPath right;
  const double end_mm = std::min(to_mm, sagittal::endMm());
  const int steps = std::max(1, static_cast<int>(std::ceil((end_mm - from_mm) / kStepMm)));
  for (int i = 0; i <= steps; ++i) {
    const double mm = std::lerp(from_mm, end_mm, static_cast<double>(i) / steps);
    const QPointF at = sagittal::placeAt(mm, flexion_);
    const QPointF way = sagittal::placeAt(mm + 2, flexion_) - sagittal::placeAt(mm - 2, flexion_);
    const double length = std::max(1e-6, std::hypot(way.x(), way.y()));
    const QPointF across = QPointF(-way.y(), way.x()) / length * sagittal::widthAt(mm) / 2;
    if (i == 0) {
      left.moveTo(at + across);
      right.moveTo(at - across);
    } else {
      left.lineTo(at + across);
      right.lineTo(at - across);
    }
  }
  left.connectPath(right.toReversed());
  left.closeSubpath();
  left.setFillRule(Qt::WindingFill);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPath(left);
}

void SagittalView::drawTube(QPainter& painter) const {
  const double tip_mm = std::clamp(depth_mm_, 0.0, sagittal::endMm());
  QPainterPath tube(sagittal::placeAt(kOutsideMm, flexion_));
  for (double mm = kOutsideMm + kStepMm; mm < tip_mm; mm += kStepMm) tube.lineTo(sagittal::placeAt(mm, flexion_));
  const QPointF tip = sagittal::placeAt(tip_mm, flexion_);
  tube.lineTo(tip);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::white, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(tube);
  painter.setPen(QPen(theme::accent(), 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(tube);
  painter.setPen(QPen(Qt::white, 1.5));
  painter.setBrush(theme::expert(1));
  painter.drawEllipse(tip, 5.5, 5.5);
}

}  // namespace tactus::workbench
