#include "app/workbench/anatomy/body_view.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/anatomy/anatomy_view.h"
#include "app/workbench/anatomy/pack_view.h"

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

bool isDrawnHere(const procedure::Procedure& procedure) {
  return procedure.pictures.empty() && procedure.id == procedure::defaultProcedure()->id;
}

bool showsPose(const procedure::Procedure& procedure, const std::string& input) {
  if (isDrawnHere(procedure)) {
    for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
      if (procedure.inputs[i].id == input) return procedure.input_notes[i].picture == procedure::LevelPicture::kPose;
    }
    return false;
  }
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
  if (isDrawnHere(*about)) return new AnatomyView(std::move(about), parent);
  return about->pictures.empty() ? makeBarView(std::move(about), parent) : makePictureView(std::move(about), parent);
}

}  // namespace tactus::workbench::anatomy
