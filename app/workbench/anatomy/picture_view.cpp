// The pictures of a pack, with the tool on their way.
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QPainterPathStroker>
#include <QPixmap>
#include <QSvgRenderer>
#include <QVariantAnimation>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "app/workbench/anatomy/pack_view.h"
#include "app/workbench/anatomy/solid.h"

namespace tactus::workbench::anatomy {
namespace {

constexpr double kMarginShare = 0.03;  // of a picture, around it
constexpr double kNearShare = 0.14;    // of the regions, around them
constexpr double kSmallPx = 26;        // a lit region that is smaller gets a wide edge of its color
constexpr double kWideEdgePx = 9;
constexpr double kNamedShare = 0.2;    // of a region: where its name points, beside the tip
constexpr double kOutsideShare = 0.1;  // of the longer side of a picture: the tool before its way
constexpr double kTopShare = 0.3;      // of the height
constexpr double kTipPx = 5;           // radius
constexpr double kStripShare = 0.25;   // of a picture: wider than any passage
constexpr int kTurnMs = 1000;          // from one pose to another
constexpr double kCostOfPx = 2;  // of the line to a plate, in pixels that the plate hides, of which one in 9 counts

class PictureView final : public PackView {
 public:
  PictureView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent) : PackView(std::move(about), parent) {
    turn_.setDuration(kTurnMs);
    turn_.setStartValue(0.0);
    turn_.setEndValue(1.0);
    turn_.setEasingCurve(QEasingCurve::InOutSine);
    connect(&turn_, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
      turned_ = value.toDouble();
      update();
    });
  }

  void setPose(const study::ItemCondition& condition, bool gently) override {
    const auto& all = about().pictures;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const procedure::Picture& picture) { return picture.pose == condition; });
    const auto wanted = found == all.end() ? std::size_t{0} : static_cast<std::size_t>(found - all.begin());
    if (wanted == shown_) return;
    turn_.stop();
    before_ = gently && isVisible() ? shown_ : wanted;
    shown_ = wanted;
    turned_ = before_ == shown_ ? 1 : 0;
    forgetLit();
    if (turned_ < 1) turn_.start();
    update();
  }

  study::ItemCondition pose() const override { return picture().pose; }

 protected:
  void forget() override {
    drawings_.clear();
    forgetLit();
  }
  void forgetLit() override {
    lit_drawing_ = {};
    name_place_.reset();
  }
  void paintEvent(QPaintEvent* event) override;

 private:
  /// A picture, near or whole.
  struct Shot {
    std::size_t picture = 0;
    bool near = false;
    auto operator<=>(const Shot&) const = default;
  };
  struct NamePlace {
    bool on_left = true;
    double y = 0;
  };

  const procedure::Picture& picture() const { return about().pictures[shown_]; }
  QRectF nearBox(std::size_t index) const;
  bool showsNear() const;
  QRectF frameOf(const Shot& shot) const;
  QTransform toWidget(const QRectF& frame) const;
  std::vector<QPointF> toolIn(const Shot& shot, double depth_mm) const;
  std::vector<QPointF> tool(double depth_mm) const;
  QPixmap drawn(const QRectF& frame, const QRectF& box, const std::function<void(QPainter&)>& draw) const;
  const QPixmap& drawing(const Shot& shot);
  void drawLit(QPainter& painter) const;
  NamePlace placeOfName(const QPointF& at);
  std::vector<PlateName> plateNames();

  std::size_t shown_ = 0;
  std::size_t before_ = 0;  ///< the pose from which the body turns
  double turned_ = 1;       ///< how much of the turn is done, [0, 1]
  QVariantAnimation turn_;
  bool near_ = false;
  mutable std::map<std::size_t, QRectF> near_boxes_;  ///< found once
  QRectF frame_;                                      ///< the part of the picture in the widget, in its units
  std::map<Shot, QPixmap> drawings_;                  ///< not mirrored
  QPixmap lit_drawing_;                               ///< likewise; the lit part alone
  std::optional<NamePlace> name_place_;
};

QRectF viewBoxOf(const procedure::Picture& picture) {
  return {picture.left, picture.top, picture.width, picture.height};
}

QPointF placeIn(const procedure::Picture& picture, double depth_mm) {
  const procedure::Point at = procedure::placeAt(picture, depth_mm);
  return {at.x, at.y};
}

std::vector<QPointF> between(const procedure::Picture& picture, double from_mm, double to_mm) {
  std::vector<QPointF> out;
  for (const Spot& spot : wayBetween(picture, from_mm, to_mm)) out.emplace_back(spot.x, spot.y);
  return out;
}

// The part that most questions are about: as the pack says, or around the regions and the beginning of the way.
QRectF PictureView::nearBox(std::size_t index) const {
  const procedure::Picture& picture = about().pictures[index];
  if (picture.near) return {picture.near->left, picture.near->top, picture.near->width, picture.near->height};
  if (const auto kept = near_boxes_.find(index); kept != near_boxes_.end()) return kept->second;
  const QSvgRenderer renderer(QByteArray::fromStdString(about().files.at(picture.file)));
  QRectF box(placeIn(picture, picture.way_mm.front()), QSizeF(1, 1));
  for (const auto& [id, outline] : picture.regions)
    box |= renderer.boundsOnElement(QStringLiteral("region_") + QString::fromStdString(id));
  const double margin = kNearShare * std::max(box.width(), box.height());
  return near_boxes_[index] = box.adjusted(-margin, -margin, margin, margin) & viewBoxOf(picture);
}

// What is lit, or the tip, lies in it.
bool PictureView::showsNear() const {
  if (whole_) return false;
  if (!picture().near) return true;
  if (names_shown_) return false;
  const auto place = lit_ ? std::optional(WayRange{lit_->from_mm, lit_->to_mm}.middleMm()) : depth_mm_;
  return !place || nearBox(shown_).contains(placeIn(picture(), *place));
}

// The part to show, extended on two sides to the shape of the widget.
QRectF PictureView::frameOf(const Shot& shot) const {
  const procedure::Picture& picture = about().pictures[shot.picture];
  const QRectF box = viewBoxOf(picture);
  const double margin = kMarginShare * std::min(box.width(), box.height());
  const QRectF part = shot.near ? nearBox(shot.picture) : box.adjusted(-margin, -margin, margin, margin);
  // Names at the edges stand beside the picture where there is room.
  double names_px = 0;
  if (names_shown_) {
    for (const RegionName& one : regionNames())
      names_px = std::max(names_px, QFontMetricsF(font()).horizontalAdvance(one.name));
  }
  const double free = std::max(1 - 2 * names_px / width(), 0.5);
  QSizeF size(width() * free, height());
  size.scale(part.size(), Qt::KeepAspectRatioByExpanding);
  size.rwidth() /= free;
  QRectF frame(QPointF(), size);
  frame.moveCenter(part.center());
  return frame;
}

QTransform PictureView::toWidget(const QRectF& frame) const {
  QTransform transform;
  if (mirrored_) {
    transform.translate(width(), 0);
    transform.scale(-1, 1);
  }
  transform.scale(width() / frame.width(), height() / frame.height());
  transform.translate(-frame.left(), -frame.top());
  return transform;
}

// In the widget.
std::vector<QPointF> PictureView::toolIn(const Shot& shot, double depth_mm) const {
  const QRectF frame = frameOf(shot);
  const QTransform to_widget = toWidget(frame);
  std::vector<QPointF> out;
  for (const Spot& spot :
       toolTo(about().pictures[shot.picture], depth_mm, kOutsideShare * std::max(frame.width(), frame.height())))
    out.push_back(to_widget.map(QPointF(spot.x, spot.y)));
  return out;
}

// While the body turns, between both poses: poses whose ways have other nodes than each other change at once.
std::vector<QPointF> PictureView::tool(double depth_mm) const {
  std::vector<QPointF> out = toolIn({shown_, near_}, depth_mm);
  if (turned_ == 1) return out;
  const auto from = toolIn({before_, near_}, depth_mm);
  for (std::size_t i = 0; i < out.size() && from.size() == out.size(); ++i)
    out[i] = from[i] + (out[i] - from[i]) * turned_;
  return out;
}

QPixmap PictureView::drawn(const QRectF& frame, const QRectF& box, const std::function<void(QPainter&)>& draw) const {
  const double ratio = devicePixelRatioF();
  QPixmap pixmap(size() * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(width() / frame.width(), height() / frame.height());
  painter.translate(-frame.topLeft());
  painter.setClipRect(box);  // beyond it a picture may end anyhow
  draw(painter);
  return pixmap;
}

// A picture takes longer than a frame to draw.
const QPixmap& PictureView::drawing(const Shot& shot) {
  QPixmap& out = drawings_[shot];
  if (out.isNull()) {
    const procedure::Picture& of = about().pictures[shot.picture];
    const QRectF frame = frameOf(shot);
    out = drawn(frame, viewBoxOf(of), [&](QPainter& onto) {
      QSvgRenderer renderer(QByteArray::fromStdString(about().files.at(of.file)));
      renderer.setViewBox(frame);
      renderer.render(&onto, frame);
    });
  }
  return out;
}

// Whole regions by their outline, others cut along the way. What the outline may be made of the renderer reads anyway.
void PictureView::drawLit(QPainter& painter) const {
  const double unit = frame_.width() / width();  // of a pixel
  for (const auto& [id, outline] : picture().regions) {
    const auto range = rangeOf(about(), id);
    if (!range || range->from_mm >= lit_->to_mm || range->to_mm <= lit_->from_mm) continue;
    const QString d = QString::fromStdString(outline);
    const auto shape = [&](double edge_px, const QColor& edge) {
      return QStringLiteral(
                 "<path id=\"lit\" d=\"%1\" fill=\"%2\" stroke=\"%3\" stroke-width=\"%4\" "
                 "stroke-linejoin=\"round\"/>")
          .arg(d, kLit.name(), edge.name())
          .arg(edge_px * unit);
    };
    const auto svg = [&](const QString& shapes) {
      return QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"%1 %2 %3 %4\">%5</svg>")
          .arg(frame_.left())
          .arg(frame_.top())
          .arg(frame_.width())
          .arg(frame_.height())
          .arg(shapes)
          .toUtf8();
    };
    QSvgRenderer lit(svg(shape(kEdgePx, kLitEdge)));
    const QSizeF size = lit.boundsOnElement(QStringLiteral("lit")).size() / unit;
    if (std::min(size.width(), size.height()) < kSmallPx)
      lit.load(svg(shape(kWideEdgePx + 2 * kEdgePx, kLitEdge) + shape(kWideEdgePx, kLit)));
    painter.save();
    if (range->from_mm < lit_->from_mm || range->to_mm > lit_->to_mm) {
      const auto points =
          between(picture(), std::max(range->from_mm, lit_->from_mm), std::min(range->to_mm, lit_->to_mm));
      QPainterPath line(points.front());
      for (const QPointF& point : points) line.lineTo(point);
      QPainterPathStroker stroker;
      stroker.setWidth(kStripShare * std::max(picture().width, picture().height));
      stroker.setCapStyle(Qt::FlatCap);
      painter.setClipPath(stroker.createStroke(line), Qt::IntersectClip);
    }
    lit.render(&painter, frame_);
    painter.restore();
  }
}

// Where a plate hides little of the picture, and is near its place.
PictureView::NamePlace PictureView::placeOfName(const QPointF& at) {
  QFont bold = font();
  bold.setBold(true);
  const QFontMetricsF metrics(bold);
  const double line = metrics.height();
  const QSizeF size(metrics.horizontalAdvance(lit_->name) + 2 * kPlatePadding * line, line * (1 + kPlatePadding));
  const QImage picture = drawing({shown_, near_}).toImage();
  const QImage lit = lit_drawing_.toImage();
  const double ratio = devicePixelRatioF();
  const QPointF tip = depth_mm_ ? tool(*depth_mm_).back() : at;
  const auto hidden = [&](const QRectF& box) {
    constexpr int kStepPx = 3;
    constexpr int kLitWeight = 1000;
    constexpr int kApartPx = 8;  // from what is lit, and from the tip
    const QRectF around = box.adjusted(-kApartPx, -kApartPx, kApartPx, kApartPx);
    int count = 0;
    for (const QPointF& point : {at, tip}) count += around.contains(point) ? kLitWeight : 0;
    for (int y = static_cast<int>(around.top()); y < around.bottom(); y += kStepPx) {
      for (int x = static_cast<int>(around.left()); x < around.right(); x += kStepPx) {
        const int drawn_x = mirrored_ ? width() - 1 - x : x;
        const QPoint pixel(static_cast<int>(drawn_x * ratio), static_cast<int>(y * ratio));
        if (box.contains(x, y) && picture.valid(pixel) && qAlpha(picture.pixel(pixel)) > 0) ++count;
        if (lit.valid(pixel) && qAlpha(lit.pixel(pixel)) > 0) count += kLitWeight;
      }
    }
    return count;
  };
  NamePlace best;
  int least = -1;
  const double top = kPlatePadding * line;
  const double bottom = height() - top - size.height();
  for (const bool on_left : {!mirrored_, mirrored_}) {
    const double x = on_left ? top : width() - top - size.width();
    constexpr int kHeights = 6;
    for (int i = kHeights; i >= 0; --i) {
      const double y = top + (bottom - top) * i / kHeights;
      // At the top of the one side stand the small pictures of the question.
      if (on_left != mirrored_ && y < kTopShare * height()) continue;
      const double inner = on_left ? x + size.width() : x;
      const double away = std::hypot(at.x() - inner, at.y() - y - size.height() / 2);
      const int cost = hidden(QRectF(QPointF(x, y), size)) + static_cast<int>(kCostOfPx * away);
      if (least >= 0 && cost >= least) continue;
      least = cost;
      best = {on_left, y};
    }
  }
  return best;
}

std::vector<PlateName> PictureView::plateNames() {
  std::vector<PlateName> out;
  const QTransform to_widget = toWidget(frame_);
  const auto spot = [&](const WayRange& range) {
    return to_widget.map(placeIn(picture(), range.from_mm + kNamedShare * (range.to_mm - range.from_mm)));
  };
  const bool named = lit_ && !lit_->name.isEmpty();
  if (names_shown_) {
    for (const RegionName& one : regionNames()) {
      const auto range = rangeOf(about(), one.id.toStdString());
      if (!range) continue;
      out.push_back(
          {one.name, to_widget.map(placeIn(picture(), range->middleMm())), false, named && one.name == lit_->name, 0});
    }
    // As many at each edge.
    std::vector<PlateName*> by_place;
    for (PlateName& one : out) by_place.push_back(&one);
    std::stable_sort(by_place.begin(), by_place.end(),
                     [](const PlateName* a, const PlateName* b) { return a->at.x() < b->at.x(); });
    for (std::size_t i = 0; i < by_place.size(); ++i) by_place[i]->on_left = i < by_place.size() / 2;
  } else if (named) {
    const QPointF at = spot({lit_->from_mm, lit_->to_mm});
    if (!name_place_) name_place_ = placeOfName(at);
    out.push_back({lit_->name, at, name_place_->on_left, true, name_place_->y, name_place_->y});
  }
  return out;
}

void PictureView::paintEvent(QPaintEvent* /*event*/) {
  if (width() < 2 || height() < 2) return;
  QPainter painter(this);
  painter.save();
  begin(painter);
  if (!drawings_.empty() && drawings_.begin()->second.devicePixelRatio() != devicePixelRatioF()) forget();
  if (const bool near = showsNear(); near != near_) {
    near_ = near;
    forgetLit();
  }
  frame_ = frameOf({shown_, near_});
  const bool lights = lit_ && turned_ == 1;
  if (lights && lit_drawing_.isNull())
    lit_drawing_ = drawn(frame_, viewBoxOf(picture()), [this](QPainter& onto) { drawLit(onto); });
  painter.save();
  if (mirrored_) {
    painter.translate(width(), 0);
    painter.scale(-1, 1);
  }
  if (turned_ < 1) {
    // One picture fades into the other.
    painter.drawPixmap(0, 0, drawing({before_, near_}));
    painter.setOpacity(turned_);
  }
  painter.drawPixmap(0, 0, drawing({shown_, near_}));
  if (lights) {
    // As if the color lay below the drawing, whose lines stay.
    painter.setCompositionMode(QPainter::CompositionMode_Multiply);
    painter.drawPixmap(0, 0, lit_drawing_);
  }
  painter.restore();
  if (depth_mm_) drawTool(painter, tool(*depth_mm_), toolPx(), kTipPx);
  painter.restore();
  painter.setRenderHint(QPainter::Antialiasing);
  if (turned_ == 1) drawPlates(painter, rect(), plateNames());
}

}  // namespace

BodyView* makePictureView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent) {
  return new PictureView(std::move(about), parent);
}

}  // namespace tactus::workbench::anatomy
