// Without a picture: the way from top to bottom, its regions one below the other.
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <utility>

#include "app/workbench/anatomy/pack_view.h"

namespace tactus::workbench::anatomy {
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

}  // namespace tactus::workbench::anatomy
