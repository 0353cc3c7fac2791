#include "app/workbench/participant/kit/pictures.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kLampMm = 20;
constexpr double kPaddingMm = 4;
constexpr QColor kStopColor(0x9B, 0x1C, 0x1C);
constexpr QColor kWaitColor(0xFF, 0xC2, 0x47);
constexpr QColor kReadyColor(0x1B, 0x6E, 0x3C);

void drawSign(QPainter& painter, Light lamp, const QRectF& box) {
  const double width = box.width() / 10;
  painter.setPen(QPen(lamp == Light::kWait ? colors::kInk : QColor(Qt::white), width, Qt::SolidLine, Qt::RoundCap));
  const double d = box.width() * 0.2;
  const QPointF c = box.center();
  switch (lamp) {
    case Light::kStop:
      painter.drawLine(c + QPointF(-d, -d), c + QPointF(d, d));
      painter.drawLine(c + QPointF(-d, d), c + QPointF(d, -d));
      break;
    case Light::kWait:
      for (const double x : {-1.1, 0.0, 1.1}) painter.drawPoint(c + QPointF(x * d, 0));
      break;
    case Light::kReady: drawTick(painter, box, width); break;
  }
}

}  // namespace

TrafficLight::TrafficLight(const Look& look, QWidget* parent) : QWidget(parent), look_(look) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(&look, &Look::changed, this, [this] {
    updateGeometry();
    update();
  });
}

void TrafficLight::setLight(Light light) {
  if (light == light_) return;
  light_ = light;
  update();
}

QSize TrafficLight::sizeHint() const {
  const int lamp = look_.mm(kLampMm);
  const int padding = look_.mm(kPaddingMm);
  return {lamp + 2 * padding, 3 * lamp + 4 * padding};
}

void TrafficLight::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double padding = look_.mm(kPaddingMm);
  const double lamp = look_.mm(kLampMm);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors::kInk);
  painter.drawRoundedRect(rect(), (lamp + 2 * padding) / 2, (lamp + 2 * padding) / 2);
  double y = padding;
  for (const Light each : {Light::kStop, Light::kWait, Light::kReady}) {
    const QRectF box(padding, y, lamp, lamp);
    const QColor on = each == Light::kStop ? kStopColor : each == Light::kWait ? kWaitColor : kReadyColor;
    const bool lit = each == light_;
    painter.setPen(lit ? QPen(Qt::white, lamp / 16) : QPen(colors::kMutedInk, 1.5));
    painter.setBrush(lit ? QBrush(on) : QBrush(colors::kInk));
    painter.drawEllipse(box.adjusted(1, 1, -1, -1));
    if (lit) drawSign(painter, each, box);
    y += lamp + padding;
  }
}

namespace {

constexpr double kDotMm = 8;
constexpr double kGapMm = 3;

}  // namespace

Dots::Dots(const Look& look, QWidget* parent) : QWidget(parent), look_(look) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(&look, &Look::changed, this, &Dots::refreshState);
}

void Dots::setCount(int filled, int all) {
  if (filled == filled_ && all == all_) return;
  filled_ = filled;
  all_ = all;
  refreshState();
}

void Dots::refreshState() {
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

namespace {

constexpr QColor kTube(0x0B, 0x65, 0x9E);
constexpr QColor kGel(0xC9, 0xE4, 0xF4);

QRectF centered(const QRectF& box, double width_share_of_height) {
  const double high = std::min(box.height(), box.width() / width_share_of_height);
  const QSizeF size(high * width_share_of_height, high);
  return {box.center() - QPointF(size.width() / 2, size.height() / 2), size};
}

void drawDrop(QPainter& painter, const QPointF& center, double radius) {
  QPainterPath drop(center + QPointF(0, -1.7 * radius));
  drop.cubicTo(center + QPointF(0.3 * radius, -1.1 * radius), center + QPointF(radius, -0.5 * radius),
               center + QPointF(radius, 0.15 * radius));
  drop.arcTo(QRectF(center.x() - radius, center.y() - 0.85 * radius, 2 * radius, 2 * radius), 0, -180);
  drop.cubicTo(center + QPointF(-radius, -0.5 * radius), center + QPointF(-0.3 * radius, -1.1 * radius),
               center + QPointF(0, -1.7 * radius));
  painter.drawPath(drop);
}

// A piece of tube with its tip to the left.
void drawTube(QPainter& painter, const QRectF& box, double height) {
  const QRectF tube(box.left(), box.center().y() - height / 2, box.width(), height);
  painter.setPen(Qt::NoPen);
  painter.setBrush(kTube);
  painter.drawRoundedRect(tube, height / 2, height / 2);
  painter.setBrush(QColor(0x7D, 0xB9, 0xDC));
  painter.drawRoundedRect(tube.adjusted(height, height * 0.22, -height, -height * 0.6), height * 0.1, height * 0.1);
}

}  // namespace

Picture strengthPicture(int level, int count) {
  return [level, count](QPainter& painter, const QRectF& box) {
    constexpr int kMostBars = 5;
    constexpr double kStep = 1.35;  // of the width of a bar
    const int last = std::max(count - 1, 1);
    const QRectF area = centered(box, 1.5);
    const double bar = area.width() / (kMostBars + (kMostBars - 1) * (kStep - 1));
    const double left = area.left() + (kMostBars - count) * bar * kStep / 2;
    const double line = std::max(1.2, area.height() / 28);
    // One hue from light to dark, whatever the number of words.
    const auto shade = static_cast<std::size_t>((level - 1) * (kMostBars - 1) / last);
    for (int i = 0; i < count; ++i) {
      const double high = area.height() * (0.28 + 0.72 * i / last);
      const QRectF shape(left + i * bar * kStep, area.bottom() - high, bar, high);
      painter.setPen(QPen(i < level ? colors::kStrength[4] : colors::kEdge, line));
      painter.setBrush(i < level ? QBrush(colors::kStrength[shade]) : QBrush(Qt::white));
      painter.drawRoundedRect(shape.adjusted(line / 2, line / 2, -line / 2, -line / 2), bar * 0.15, bar * 0.15);
    }
  };
}

namespace {

// Three signs fill the width of a picture; more of them are drawn smaller.
double shrink(int count) { return std::min(1.0, 3.0 / count); }

}  // namespace

Picture dropsPicture(int level, int count) {
  return [level, count](QPainter& painter, const QRectF& box) {
    const QRectF area = centered(box, 1.5);
    const double high = area.height();
    const QRectF tube(area.left(), area.top() + high * 0.62, area.width(), high * 0.3);
    if (level == count && count > 1) {
      painter.setPen(QPen(colors::kAccent, std::max(1.0, high / 40)));
      painter.setBrush(kGel);
      painter.drawRoundedRect(tube.adjusted(0, -high * 0.08, 0, high * 0.08), high * 0.2, high * 0.2);
    }
    drawTube(painter, tube.adjusted(high * 0.08, 0, -high * 0.08, 0), high * 0.22);
    painter.setPen(QPen(colors::kAccent, std::max(1.2, high / 32)));
    const double step = 0.28 * shrink(count);
    for (int i = 0; i < count; ++i) {
      painter.setBrush(i < level ? QBrush(colors::kStrength[2]) : QBrush(Qt::white));
      if (i >= level) painter.setPen(QPen(colors::kEdge, std::max(1.0, high / 40), Qt::DotLine));
      const double x = 0.22 + 0.28 - step * (count - 1) / 2 + step * i;
      drawDrop(painter, {area.left() + area.width() * x, area.top() + high * 0.33}, high * 0.15 * shrink(count));
    }
  };
}

Picture arrowsPicture(int level, int count) {
  return [level, count](QPainter& painter, const QRectF& box) {
    const QRectF area = centered(box, 1.5);
    const double high = area.height();
    drawTube(painter, QRectF(area.left(), area.top() + high * 0.7, area.width(), high * 0.22), high * 0.22);
    const double small = shrink(count);
    const double step = 0.27 * small;
    const double first = 0.16 + (2 * 0.27 - (count - 1) * step) / 2;
    for (int i = 0; i < count; ++i) {
      painter.setPen(i < level ? QPen(colors::kAccent, high * 0.11 * small, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)
                               : QPen(colors::kEdge, std::max(1.2, high / 32), Qt::DotLine));
      painter.setBrush(Qt::NoBrush);
      // Into the patient, who looks left: to the right.
      const double x = area.left() + area.width() * first + i * area.width() * step;
      QPainterPath arrow(QPointF(x, area.top() + high * 0.08));
      arrow.lineTo(x + high * 0.2 * small, area.top() + high * 0.3);
      arrow.lineTo(x, area.top() + high * 0.52);
      painter.drawPath(arrow);
    }
  };
}

Picture blocksPicture(int level, int count) {
  return [level, count](QPainter& painter, const QRectF& box) {
    const QRectF area = centered(box, 1.5);
    const double high = area.height();
    const double line = std::max(1.2, high / 28);
    const double side = high * 0.42 * shrink(count);
    const double step = side * 1.12;
    const double left = area.center().x() - (side + step * (count - 1)) / 2;
    for (int i = 0; i < count; ++i) {
      painter.setPen(i < level ? QPen(colors::kAccent, line) : QPen(colors::kEdge, line, Qt::DotLine));
      painter.setBrush(i < level ? QBrush(colors::kStrength[2]) : QBrush(Qt::white));
      const QRectF block(left + i * step, area.center().y() - side / 2, side, side);
      painter.drawRoundedRect(block.adjusted(line / 2, line / 2, -line / 2, -line / 2), side * 0.15, side * 0.15);
    }
  };
}

namespace {

/// An arrow back, out of the patient, above the tip of the tool.
Picture wayOutPicture() {
  return [](QPainter& painter, const QRectF& box) {
    const QRectF area = centered(box, 1.5);
    const double high = area.height();
    drawTube(painter, QRectF(area.left(), area.top() + high * 0.7, area.width(), high * 0.22), high * 0.22);
    painter.setPen(QPen(colors::kAccent, high * 0.11, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    const QPointF tip(area.left() + area.width() * 0.18, area.top() + high * 0.32);
    QPainterPath arrow(tip + QPointF(high * 0.2, -high * 0.2));
    arrow.lineTo(tip);
    arrow.lineTo(tip + QPointF(high * 0.2, high * 0.2));
    arrow.moveTo(tip);
    arrow.lineTo(area.right() - area.width() * 0.18, tip.y());
    painter.drawPath(arrow);
  };
}

}  // namespace

Picture conditionPicture(const procedure::Procedure& procedure, const study::ItemCondition& condition) {
  if (condition == study::kWayOut) return wayOutPicture();
  const auto input = std::find_if(procedure.inputs.begin(), procedure.inputs.end(),
                                  [&](const fuzzy::Variable& one) { return one.id == condition.input; });
  if (input == procedure.inputs.end()) return {};
  const auto term = std::find_if(input->terms.begin(), input->terms.end(),
                                 [&](const fuzzy::Term& one) { return one.id == condition.term; });
  if (term == input->terms.end()) return {};
  const int level = static_cast<int>(term - input->terms.begin()) + 1;
  const int count = static_cast<int>(input->terms.size());
  using procedure::LevelPicture;
  switch (procedure.input_notes[static_cast<std::size_t>(input - procedure.inputs.begin())].picture) {
    case LevelPicture::kDrops: return dropsPicture(level, count);
    case LevelPicture::kArrows: return arrowsPicture(level, count);
    case LevelPicture::kPose:
      if (anatomy::showsPose(procedure, condition.input)) return {};
      break;
    case LevelPicture::kBars: break;
  }
  return blocksPicture(level, count);
}

std::vector<anatomy::RegionName> regionNames(const Look& look) {
  std::vector<anatomy::RegionName> out;
  std::vector<std::string> asked = procedure::regionsOf(*look.about(), look.form());
  if (asked.empty()) {  // the form has questions about conditions alone
    for (const fuzzy::Term& term : look.about()->wayInput().terms) asked.push_back(term.id);
  }
  for (const std::string& region : asked) {
    const QString id = QString::fromStdString(region);
    out.push_back({id, look.say(phrase(QStringLiteral("a.") + id))});
  }
  return out;
}

Picture textSizePicture(int percent) {
  return [percent](QPainter& painter, const QRectF& box) {
    // Drawn as a path: it is a picture of a size, not a text of the screen.
    QFont font = painter.font();
    font.setPixelSize(std::max(1, static_cast<int>(box.height() * 0.8 * percent / 150)));
    font.setBold(true);
    QPainterPath letter;
    letter.addText(0, 0, font, QStringLiteral("A"));
    const QRectF bounds = letter.boundingRect();
    letter.translate(box.center().x() - bounds.center().x(), box.bottom() - box.height() * 0.1);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors::kInk);
    painter.drawPath(letter);
  };
}

Picture pushPicture() {
  return [](QPainter& painter, const QRectF& box) {
    const QRectF area = centered(box, 2);
    const double u = area.height() / 20;
    const QPointF o = area.topLeft();
    painter.setPen(QPen(colors::kAccent, u * 0.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::white);
    // A pen on its arm, held at its thick end.
    QPainterPath pen(o + QPointF(1.5, 14) * u);
    pen.lineTo(o + QPointF(12, 8) * u);
    pen.lineTo(o + QPointF(15.5, 8) * u);
    pen.lineTo(o + QPointF(14, 11.2) * u);
    pen.lineTo(o + QPointF(3.5, 17.4) * u);
    pen.closeSubpath();
    painter.drawPath(pen);
    painter.setBrush(colors::kAccent);
    painter.drawEllipse(o + QPointF(16.5, 7.6) * u, 1.2 * u, 1.2 * u);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors::kAccent, u * 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawLine(o + QPointF(22, 7.6) * u, o + QPointF(37, 7.6) * u);
    painter.drawPolyline(QPolygonF({o + QPointF(32, 2.8) * u, o + QPointF(37.5, 7.6) * u, o + QPointF(32, 12.4) * u}));
  };
}

namespace {

const QPen kOutline(colors::kInk, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);

/// An arrow onto what is pressed; its tip is `at`.
void drawPress(QPainter& painter, const QPointF& at, double length) {
  painter.setPen(QPen(colors::kInk, 3, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(at - QPointF(0, length), at);
  painter.drawLine(at, at + QPointF(-length / 4, -length / 4));
  painter.drawLine(at, at + QPointF(length / 4, -length / 4));
}

// In a box of 60 x 40.
void drawStylus(QPainter& painter) {
  painter.save();
  painter.translate(30, 26);
  painter.rotate(-20);
  painter.setPen(kOutline);
  painter.setBrush(colors::kCard);
  painter.drawRoundedRect(QRectF(-24, -5, 48, 10), 5, 5);
  painter.drawLine(QPointF(24, 0), QPointF(29, 0));
  painter.setBrush(kReadyColor);
  painter.drawEllipse(QPointF(8, -4), 4, 2.5);
  painter.restore();
  drawPress(painter, QPointF(35.5, 16), 12);
}

void drawPedal(QPainter& painter) {
  painter.setPen(kOutline);
  painter.setBrush(colors::kCard);
  painter.drawRect(QRectF(10, 33, 40, 4));
  painter.setBrush(kReadyColor);
  painter.drawPolygon(QPolygonF{{12, 30}, {48, 24}, {48, 29}, {12, 33}});
  drawPress(painter, QPointF(36, 22), 14);
}

void drawMouse(QPainter& painter) {
  painter.setPen(kOutline);
  painter.setBrush(colors::kCard);
  painter.drawRoundedRect(QRectF(8, 10, 18, 27), 9, 9);
  QPainterPath body;
  body.addRoundedRect(QRectF(8, 10, 18, 27), 9, 9);
  QPainterPath left;
  left.addRect(QRectF(8, 10, 9, 12));
  painter.setBrush(kReadyColor);
  painter.drawPath(body.intersected(left));
  drawPress(painter, QPointF(12, 9), 8);
  painter.setBrush(kReadyColor);
  painter.drawRoundedRect(QRectF(34, 26, 22, 8), 2, 2);
  drawPress(painter, QPointF(45, 24), 12);
}

}  // namespace

Picture holdPicture(HoldMeans hold) {
  return [hold](QPainter& painter, const QRectF& box) {
    painter.save();
    const double scale = std::min(box.width() / 60, box.height() / 40);
    painter.translate(box.center() - QPointF(30, 20) * scale);
    painter.scale(scale, scale);
    switch (hold) {
      case HoldMeans::kButton:
      case HoldMeans::kLatch: drawStylus(painter); break;
      case HoldMeans::kPedal: drawPedal(painter); break;
      case HoldMeans::kMouse: drawMouse(painter); break;
    }
    painter.restore();
  };
}

Picture tickPicture() {
  return [](QPainter& painter, const QRectF& box) {
    const QRectF area = centered(box, 1);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors::kAccent);
    painter.drawEllipse(area);
    painter.setPen(Qt::white);
    drawTick(painter, area, area.width() / 9);
  };
}

Picture cupPicture() {
  return [](QPainter& painter, const QRectF& box) {
    const QRectF area = centered(box, 1);
    const double u = area.width() / 20;
    const QPointF o = area.topLeft();
    const QPen pen(colors::kAccent, u * 0.9, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QRectF(o.x() + 12.5 * u, o.y() + 9 * u, 5 * u, 5 * u));
    painter.setBrush(Qt::white);
    QPainterPath cup(o + QPointF(3, 8) * u);
    cup.lineTo(o + QPointF(15, 8) * u);
    cup.cubicTo(o + QPointF(15, 14) * u, o + QPointF(13, 16.5) * u, o + QPointF(9, 16.5) * u);
    cup.cubicTo(o + QPointF(5, 16.5) * u, o + QPointF(3, 14) * u, o + QPointF(3, 8) * u);
    painter.drawPath(cup);
    painter.setBrush(Qt::NoBrush);
    painter.drawLine(o + QPointF(2, 19) * u, o + QPointF(16, 19) * u);
    painter.setPen(QPen(colors::kStrength[2], u * 0.8, Qt::SolidLine, Qt::RoundCap));
    for (const double x : {6.5, 11.5}) {
      QPainterPath steam(o + QPointF(x, 5.5) * u);
      steam.cubicTo(o + QPointF(x - 1.6, 4) * u, o + QPointF(x + 1.6, 2.8) * u, o + QPointF(x, 1) * u);
      painter.drawPath(steam);
    }
  };
}

void drawTick(QPainter& painter, const QRectF& box, double width) {
  QPainterPath tick(QPointF(box.left() + box.width() * 0.22, box.top() + box.height() * 0.52));
  tick.lineTo(box.left() + box.width() * 0.43, box.top() + box.height() * 0.72);
  tick.lineTo(box.left() + box.width() * 0.78, box.top() + box.height() * 0.3);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(painter.pen().color(), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(tick);
}

}  // namespace tactus::workbench::nurse
