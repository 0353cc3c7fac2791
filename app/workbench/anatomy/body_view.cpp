#include "app/workbench/anatomy/body_view.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QSvgRenderer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/anatomy/pack_view.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench::anatomy {

// Without a picture: the way from top to bottom, its regions one below the other.

namespace {

class BarView final : public PackView {
 public:
  using PackView::PackView;

  void setPose(const study::ItemCondition& /*condition*/, bool /*gently*/) override {}

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Part {
    WayRange range;
    QString id;
  };

  std::vector<Part> parts() const;
  std::vector<PlateName> plateNames(const QRectF& bar, double room) const;
  double yOf(const QRectF& bar, double mm) const;
};

std::vector<BarView::Part> BarView::parts() const {
  std::vector<Part> out;
  for (const fuzzy::Term& term : about().wayInput().terms) {
    if (const auto range = rangeOf(about(), term.id)) out.push_back({*range, QString::fromStdString(term.id)});
  }
  return out;
}

double BarView::yOf(const QRectF& bar, double mm) const {
  const fuzzy::Variable& way = about().wayInput();
  return bar.top() + bar.height() * (std::clamp(mm, way.min, way.max) - way.min) / (way.max - way.min);
}

// All of them where there is room, otherwise the lit one.
std::vector<PlateName> BarView::plateNames(const QRectF& bar, double room) const {
  const double plate = QFontMetricsF(font()).height() * (1 + kPlatePadding) * 1.3;
  const bool all = plate * static_cast<double>(regionNames().size()) < room;
  std::vector<PlateName> out;
  for (const RegionName& one : regionNames()) {
    const auto range = rangeOf(about(), one.id.toStdString());
    const bool lit = lit_ && lit_->name == one.name;
    if (!range || (!all && !lit)) continue;
    const double y = (yOf(bar, range->from_mm) + yOf(bar, range->to_mm)) / 2;
    out.push_back({one.name, QPointF(mirrored_ ? bar.left() : bar.right(), y), mirrored_, lit, 0});
  }
  return out;
}

void BarView::paintEvent(QPaintEvent* /*event*/) {
  if (width() < 2 || height() < 2) return;
  QPainter painter(this);
  painter.save();
  begin(painter);
  QFont bold = font();
  bold.setBold(true);
  const QFontMetricsF metrics(bold);
  const double line = metrics.height();
  double name_width = 0;
  for (const RegionName& one : regionNames()) name_width = std::max(name_width, metrics.horizontalAdvance(one.name));
  const double bar_width = std::clamp(0.16 * std::min(width(), height()), 28.0, 72.0);
  const double names_room = name_width > 0 ? name_width + 2.8 * line : 0;
  const double all_width = std::min(bar_width + names_room, width() - line);
  const QRectF area((width() - all_width) / 2, line / 2, all_width, height() - line);
  const double outside = 0.12 * area.height();
  const QRectF bar(mirrored_ ? area.right() - bar_width : area.left(), area.top() + outside, bar_width,
                   area.height() - outside);

  constexpr QColor kFills[] = {QColor(0xF3, 0xE3, 0xDA), QColor(0xE6, 0xCB, 0xBD)};
  constexpr QColor kEdge(0xB9, 0x8A, 0x70);
  QPainterPath shape;
  shape.addRoundedRect(bar, bar_width / 4, bar_width / 4);
  painter.save();
  painter.setClipPath(shape, Qt::IntersectClip);
  std::size_t number = 0;
  for (const Part& part : parts()) {
    const double top = yOf(bar, part.range.from_mm);
    painter.fillRect(QRectF(bar.left(), top, bar_width, yOf(bar, part.range.to_mm) - top), kFills[number++ % 2]);
  }
  painter.restore();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kEdge, 1.5));
  painter.drawPath(shape);
  if (lit_) {
    const double top = yOf(bar, lit_->from_mm);
    QPainterPath part;
    part.addRect(QRectF(bar.left(), top, bar_width, yOf(bar, lit_->to_mm) - top));
    painter.setBrush(kLit);
    painter.setPen(QPen(kLitEdge, kEdgePx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(shape.intersected(part));
  }
  if (depth_mm_) {
    const double x = bar.center().x();
    const bool before = *depth_mm_ < about().wayInput().min;
    const QPointF tip(x, before ? bar.top() - outside / 2 : yOf(bar, *depth_mm_));
    drawTool(painter, {QPointF(x, 0), tip}, toolPx());
  }
  painter.restore();
  painter.setRenderHint(QPainter::Antialiasing);
  drawPlates(painter, area, plateNames(bar, area.height()));
}

}  // namespace

BodyView* makeBarView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent) {
  return new BarView(std::move(about), parent);
}

std::optional<WayRange> rangeOf(const procedure::Procedure& procedure, const std::string& region) {
  const fuzzy::Variable& way = procedure.wayInput();
  for (const procedure::TermSet& set : procedure.way_terms) {
    const fuzzy::Term* const term = fuzzy::findTerm(set.terms, region);
    if (term == nullptr || term->points.size() != 4) continue;
    const auto& points = term->points;
    return WayRange{std::max((points[0] + points[1]) / 2, way.min), std::min((points[2] + points[3]) / 2, way.max)};
  }
  return std::nullopt;
}

bool showsPose(const procedure::Procedure& procedure, const std::string& input) {
  return std::any_of(procedure.pictures.begin(), procedure.pictures.end(),
                     [&](const procedure::Picture& picture) { return picture.pose.input == input; });
}

namespace {

constexpr double kLeastToolPx = 4;
constexpr double kHaloPx = 3;
constexpr QColor kTool(0x0B, 0x65, 0x9E);
constexpr QColor kToolShine(0x7D, 0xB9, 0xDC);

}  // namespace

void drawTool(QPainter& painter, const std::vector<QPointF>& points, double width, double least_tip) {
  QPainterPath tool(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) tool.lineTo(points[i]);
  width = std::max(kLeastToolPx, width);
  const auto stroke = [&](const QColor& color, double pen_width) {
    painter.setPen(QPen(color, pen_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(tool);
  };
  painter.setBrush(Qt::NoBrush);
  stroke(Qt::white, width + 4);
  stroke(kTool, width);
  stroke(kToolShine, std::max(1.0, width / 4));
  const double tip = std::max(least_tip, width * 0.85);
  painter.setPen(Qt::NoPen);
  painter.setBrush(Qt::white);
  painter.drawEllipse(points.back(), tip + kHaloPx, tip + kHaloPx);
  painter.setBrush(kTool);
  painter.drawEllipse(points.back(), tip, tip);
}

namespace {

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
    const QSizeF size(metrics.horizontalAdvance(name.text) + 2 * kPlatePadding * line, line * (1 + kPlatePadding));
    const double x = left ? area.left() + kPlatePadding * line : area.right() - kPlatePadding * line - size.width();
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

BodyView::BodyView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent)
    : QWidget(parent), about_(std::move(about)) {}

void BodyView::showTipIn(const QString& region) {
  const auto range = rangeOf(*about_, region.toStdString());
  setDepth(range ? std::optional(range->middleMm()) : std::nullopt);
}

void BodyView::setRegionNames(std::vector<RegionName> names) {
  names_ = std::move(names);
  update();
}

bool BodyView::isSame(const std::optional<double>& depth_mm, const std::optional<double>& other_mm) {
  constexpr double kDrawnMm = 0.1;
  if (depth_mm.has_value() != other_mm.has_value()) return false;
  return std::abs(depth_mm.value_or(0) - other_mm.value_or(0)) < kDrawnMm;
}

QString BodyView::nameOf(const QString& region) const {
  const auto found =
      std::find_if(names_.begin(), names_.end(), [&](const RegionName& one) { return one.id == region; });
  return found == names_.end() ? QString() : found->name;
}

BodyView* makeBodyView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent) {
  return about->pictures.empty() ? makeBarView(std::move(about), parent) : makePictureView(std::move(about), parent);
}

namespace {

QPixmap drawn(const QByteArray& svg, const QSize& size, double ratio) {
  QPixmap pixmap(size * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(theme::card());
  QSvgRenderer renderer(svg);
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

InsetView::InsetView(QByteArray svg, QWidget* parent) : QWidget(parent), svg_(std::move(svg)) {}

void InsetView::paintEvent(QPaintEvent* /*event*/) {
  if (width() < 2 || height() < 2) return;
  const double ratio = devicePixelRatioF();
  if (drawing_.size() != size() * ratio) drawing_ = drawn(svg_, size(), ratio);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath corners;
  corners.addRoundedRect(rect(), theme::kCornerRadius, theme::kCornerRadius);
  painter.setClipPath(corners);
  painter.drawPixmap(0, 0, drawing_);
}

}  // namespace tactus::workbench::anatomy
