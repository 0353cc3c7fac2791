#include "app/workbench/anatomy/anatomy_view.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPathStroker>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/theme.h"

namespace tactus::workbench::anatomy {
namespace {

constexpr double kPadding = 0.4;  // of the height of a line
constexpr double kGap = 0.25;
constexpr double kDot = 3;  // px, radius at the named place

struct Plate {
  const PlateName* name;
  QRectF box;
};

// One edge of the picture: plates as near to their places as there is room.
std::vector<Plate> plates(const QPainter& painter, const QRectF& area, const std::vector<PlateName>& names, bool left) {
  std::vector<Plate> out;
  for (const PlateName& name : names) {
    if (name.on_left != left) continue;
    QFont font = painter.font();
    font.setBold(name.lit);
    const QFontMetricsF metrics(font);
    const double line = metrics.height();
    const QSizeF size(metrics.horizontalAdvance(name.text) + 2 * kPadding * line, line * (1 + kPadding));
    const double x = left ? area.left() + kPadding * line : area.right() - kPadding * line - size.width();
    out.push_back({&name, QRectF(QPointF(x, name.at.y() - size.height() / 2), size)});
  }
  std::sort(out.begin(), out.end(), [](const Plate& a, const Plate& b) { return a.name->at.y() < b.name->at.y(); });
  double free_y = area.top() + kDot * 2;
  for (Plate& plate : out) {
    plate.box.moveTop(std::min(std::max({plate.box.top(), free_y, plate.name->least_y}), plate.name->most_y));
    free_y = plate.box.bottom() + kGap * plate.box.height();
  }
  double last_y = area.bottom() - kDot * 2;
  for (auto plate = out.rbegin(); plate != out.rend(); ++plate) {
    plate->box.moveBottom(std::min(plate->box.bottom(), last_y));
    last_y = plate->box.top() - kGap * plate->box.height();
  }
  return out;
}

}  // namespace

void drawPlates(QPainter& painter, const QRectF& area, std::vector<PlateName> names) {
  const QFont font = painter.font();
  for (const bool left : {true, false}) {
    for (const Plate& plate : plates(painter, area, names, left)) {
      // From above the line leaves the plate at its top.
      const bool above = plate.name->at.y() < plate.box.top() - plate.box.height();
      const double inner = left ? plate.box.right() : plate.box.left();
      const double inward = (left ? -1 : 1) * plate.box.height() / 2;
      const QPointF edge = above ? QPointF(inner + inward, plate.box.top()) : QPointF(inner, plate.box.center().y());
      painter.setPen(QPen(theme::card(), 4.5, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(edge, plate.name->at);
      painter.setPen(QPen(theme::ink(), 1.75, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(edge, plate.name->at);
      painter.setBrush(theme::ink());
      painter.setPen(QPen(theme::card(), 1.5));
      painter.drawEllipse(plate.name->at, kDot + 1, kDot + 1);
      painter.setPen(QPen(theme::ink(), plate.name->lit ? 2 : 1));
      painter.setBrush(theme::card());
      painter.drawRoundedRect(plate.box, 6, 6);
      QFont own = font;
      own.setBold(plate.name->lit);
      painter.setFont(own);
      painter.drawText(plate.box, Qt::AlignCenter, plate.name->text);
    }
  }
  painter.setFont(font);
}

namespace {

constexpr int kTurnMs = 1000;
constexpr double kTubeMm = 4.7;    // 14 Fr
constexpr double kPassageMm = 60;  // wider than any part of the passage
constexpr double kEndMm = 514;     // of the path
constexpr double kInStomachMm = 490;

QPainterPath lineThrough(const std::vector<QPointF>& points) {
  QPainterPath path(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) path.lineTo(points[i]);
  return path;
}

// The passage between two depths, mm. A whole region keeps its outline as drawn.
QPainterPath passage(double from_mm, double to_mm, Posture posture, const TubeWay& way) {
  QPainterPath all;
  QPainterPath regions;
  for (std::size_t i = 0; i < kRegions.size(); ++i) {
    const double begin = beginMm(kRegions[i]);
    const double end = i + 1 < kRegions.size() ? beginMm(kRegions[i + 1]) : kEndMm;
    if (begin >= to_mm || end <= from_mm) continue;
    const QPainterPath outline = outlineOf(kRegions[i], posture);
    if (begin >= from_mm && end <= to_mm) {
      regions.addPath(outline);
      continue;
    }
    QPainterPathStroker stroker;
    stroker.setWidth(kPassageMm);
    stroker.setCapStyle(Qt::FlatCap);
    const QPainterPath strip =
        stroker.createStroke(lineThrough(way.between(std::max(begin, from_mm), std::min(end, to_mm))));
    regions.addPath(outline.intersected(strip));
  }
  regions.setFillRule(Qt::WindingFill);
  return regions;
}

}  // namespace

AnatomyView::AnatomyView(QWidget* parent) : AnatomyView(procedure::defaultProcedure(), parent) {}

AnatomyView::AnatomyView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent)
    : BodyView(std::move(about), parent) {
  turn_.setDuration(kTurnMs);
  turn_.setStartValue(0.0);
  turn_.setEndValue(1.0);
  turn_.setEasingCurve(QEasingCurve::InOutSine);
  connect(&turn_, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
    turned_ = value.toDouble();
    way_ = TubeWay(flexionDeg());
    update();
  });
}

double AnatomyView::flexionDeg() const {
  return std::lerp(drawnFlexionDeg(posture_before_), drawnFlexionDeg(posture_), turned_);
}

void AnatomyView::setPosture(Posture posture, bool gently) {
  if (posture == posture_) return;
  turn_.stop();
  posture_before_ = gently && isVisible() ? posture_ : posture;
  posture_ = posture;
  turned_ = posture_before_ == posture ? 1 : 0;
  way_ = TubeWay(flexionDeg());
  lit_path_ = litPath();
  if (turned_ < 1) turn_.start();
  update();
}

void AnatomyView::setFraming(Framing framing) {
  if (framing_ == framing) return;
  framing_ = framing;
  update();
}

void AnatomyView::setMirrored(bool mirrored) {
  if (mirrored_ == mirrored) return;
  mirrored_ = mirrored;
  update();
}

void AnatomyView::setDepth(std::optional<double> depth_mm) {
  if (isSame(depth_mm, depth_mm_)) return;
  depth_mm_ = depth_mm;
  update();
}

// The drawings stand in the order of the words.
void AnatomyView::setPose(const study::ItemCondition& condition) {
  Posture posture = Posture::kUpright;
  for (const fuzzy::Variable& input : about().inputs) {
    if (input.id != condition.input || !showsPose(about(), input.id)) continue;
    const auto place = static_cast<int>(std::find_if(input.terms.begin(), input.terms.end(),
                                                     [&](const auto& term) { return term.id == condition.term; }) -
                                        input.terms.begin());
    posture = static_cast<Posture>(std::min(place, static_cast<int>(Posture::kChinOnChest)));
  }
  setPosture(posture);
}

void AnatomyView::lightRegion(const QString& id) {
  const auto region = regionWithId(id.toStdString());
  if (!region) return light(std::nullopt);
  setFraming(*region >= Region::kEsophagus ? Framing::kWhole : Framing::kThroat);
  light(*region, nameOf(id));
}

void AnatomyView::showNames() {
  std::vector<NamedStructure> names;
  for (const RegionName& one : regionNames()) {
    if (const auto region = regionWithId(one.id.toStdString())) names.push_back({structureOf(*region), one.name});
  }
  setNames(std::move(names));
}

void AnatomyView::showWhole() {
  setFraming(Framing::kWhole);
  setDepth(kInStomachMm);
}

void AnatomyView::light(Region region, const QString& name) {
  const bool last = region == kRegions.back();
  const double end = last ? kEndMm : beginMm(kRegions[static_cast<std::size_t>(region) + 1]);
  light(LitRange{beginMm(region), end, name});
}

void AnatomyView::light(const std::optional<LitRange>& range) {
  if (lit_ == range) return;
  lit_ = range;
  lit_path_ = litPath();
  update();
}

void AnatomyView::setNames(std::vector<NamedStructure> names) {
  names_ = std::move(names);
  update();
}

QPainterPath AnatomyView::litPath() const {
  if (!lit_) return {};
  return passage(lit_->from_mm, lit_->to_mm, posture_, TubeWay(drawnFlexionDeg(posture_)));
}

QTransform AnatomyView::toWidget() const {
  const QSizeF size = QSizeF(this->size());
  const QRectF before = frameOf(framing_, posture_before_, size);
  const QRectF now = frameOf(framing_, posture_, size);
  const QPointF corner = before.topLeft() + (now.topLeft() - before.topLeft()) * turned_;
  const double scale = size.width() / now.width();
  QTransform transform;
  if (mirrored_) {
    transform.translate(size.width(), 0);
    transform.scale(-1, 1);
  }
  transform.scale(scale, scale);
  transform.translate(-corner.x(), -corner.y());
  return transform;
}

double AnatomyView::radius() const { return theme::kCornerRadius; }

void AnatomyView::paintEvent(QPaintEvent* /*event*/) {
  if (width() < 2 || height() < 2) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath corners;
  corners.addRoundedRect(rect(), radius(), radius());
  painter.save();
  painter.setClipPath(corners);
  painter.fillRect(rect(), theme::card());
  drawPicture(painter);
  const QTransform to_widget = toWidget();
  if (lit_ && turned_ == 1) {
    painter.save();
    painter.setTransform(to_widget, true);
    // As if the color lay below the drawing, whose lines stay.
    painter.setCompositionMode(QPainter::CompositionMode_Multiply);
    painter.fillPath(lit_path_, kLit);
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kLitEdge, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(lit_path_);
    painter.restore();
  }
  drawTube(painter, to_widget);
  painter.restore();
  drawPlates(painter, rect(), plateNames(to_widget));
}

void AnatomyView::drawPicture(QPainter& painter) {
  painter.save();
  if (mirrored_) {
    painter.translate(width(), 0);
    painter.scale(-1, 1);
  }
  const double ratio = devicePixelRatioF();
  if (turned_ < 1) {
    // While the neck turns, one picture fades into the other.
    painter.drawPixmap(0, 0, drawing_.pixmap(posture_before_, framing_, size(), ratio));
    painter.setOpacity(turned_);
  }
  painter.drawPixmap(0, 0, drawing_.pixmap(posture_, framing_, size(), ratio));
  painter.restore();
}

void AnatomyView::drawTube(QPainter& painter, const QTransform& to_widget) const {
  if (!depth_mm_) return;
  std::vector<QPointF> points = way_.between(way_.beginMm(), std::max(*depth_mm_, way_.beginMm() + 1));
  for (QPointF& point : points) point = to_widget.map(point);
  drawTool(painter, points, kTubeMm * 0.77 * std::abs(to_widget.m11()));
}

std::vector<PlateName> AnatomyView::plateNames(const QTransform& to_widget) const {
  std::vector<PlateName> plates;
  const auto placeOf = [&](const Structure& structure) {
    return to_widget.map(posed(structure.at, structure.part, flexionDeg()));
  };
  if (lit_ && !lit_->name.isEmpty() && turned_ == 1) {
    const auto region = regionAtDepth((lit_->from_mm + std::min(lit_->to_mm, kEndMm)) / 2);
    // Beside the region, on the side of the neck: on the other one the line would cross the face.
    if (region) plates.push_back({lit_->name, placeOf(structureOf(*region)), mirrored_, true});
  }
  for (const NamedStructure& named : names_) {
    const bool left = (named.structure.side == Side::kFront) != mirrored_;
    plates.push_back({named.name, placeOf(named.structure), left, false});
  }
  return plates;
}

}  // namespace tactus::workbench::anatomy
