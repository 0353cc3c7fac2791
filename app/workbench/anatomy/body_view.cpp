#include "app/workbench/anatomy/body_view.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/anatomy/pack_view.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench::anatomy {

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

}  // namespace tactus::workbench::anatomy
