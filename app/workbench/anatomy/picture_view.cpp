// The pictures of a pack, with the tool on their way.
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QPainterPathStroker>
#include <QPixmap>
#include <QSvgRenderer>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "app/workbench/anatomy/anatomy_view.h"
#include "app/workbench/anatomy/pack_view.h"

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

QByteArray bytesOf(const std::string& text) { return {text.data(), static_cast<qsizetype>(text.size())}; }

class PictureView final : public PackView {
 public:
  using PackView::PackView;

  void setPose(const study::ItemCondition& condition) override {
    const auto& all = about().pictures;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const procedure::Picture& picture) { return picture.pose == condition; });
    change(shown_, found == all.end() ? std::size_t{0} : static_cast<std::size_t>(found - all.begin()));
  }

 protected:
  void forget() override {
    drawing_ = lit_drawing_ = {};
    name_place_.reset();
  }
  void paintEvent(QPaintEvent* event) override;

 private:
  struct NamePlace {
    bool on_left = true;
    double y = 0;
  };

  const procedure::Picture& picture() const { return about().pictures[shown_]; }
  QRectF viewBox() const;
  QRectF nearBox() const;
  void findFrame();
  QTransform toWidget() const;
  QPointF placeAt(double depth_mm) const;
  std::vector<QPointF> between(double from_mm, double to_mm) const;
  std::vector<QPointF> toolTo(double depth_mm) const;
  QPixmap drawn(const std::function<void(QPainter&)>& draw) const;
  void drawLit(QPainter& painter) const;
  NamePlace placeOfName(const QPointF& at) const;
  std::vector<PlateName> plateNames();

  std::size_t shown_ = 0;
  QRectF frame_;         ///< the part of the picture in the widget, in its units
  QPixmap drawing_;      ///< not mirrored
  QPixmap lit_drawing_;  ///< likewise; the lit part alone
  std::optional<NamePlace> name_place_;
};

QRectF PictureView::viewBox() const { return {picture().left, picture().top, picture().width, picture().height}; }

// Around the regions and the beginning of the way.
QRectF PictureView::nearBox() const {
  const QSvgRenderer renderer(bytesOf(about().files.at(picture().file)));
  QRectF box(placeAt(picture().way_mm.front()), QSizeF(1, 1));
  for (const auto& [id, outline] : picture().regions)
    box |= renderer.boundsOnElement(QStringLiteral("region_") + QString::fromStdString(id));
  const double margin = kNearShare * std::max(box.width(), box.height());
  return box.adjusted(-margin, -margin, margin, margin) & viewBox();
}

// The part to show, extended on two sides to the shape of the widget.
void PictureView::findFrame() {
  const QRectF box = viewBox();
  const double margin = kMarginShare * std::min(box.width(), box.height());
  const QRectF part = whole_ ? box.adjusted(-margin, -margin, margin, margin) : nearBox();
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
  frame_ = QRectF(QPointF(), size);
  frame_.moveCenter(part.center());
}

QTransform PictureView::toWidget() const {
  QTransform transform;
  if (mirrored_) {
    transform.translate(width(), 0);
    transform.scale(-1, 1);
  }
  transform.scale(width() / frame_.width(), height() / frame_.height());
  transform.translate(-frame_.left(), -frame_.top());
  return transform;
}

QPointF PictureView::placeAt(double depth_mm) const {
  const auto& mm = picture().way_mm;
  const double depth = std::clamp(depth_mm, mm.front(), mm.back());
  const auto next = std::upper_bound(mm.begin() + 1, mm.end() - 1, depth);
  const auto i = static_cast<std::size_t>(next - mm.begin());
  const procedure::Point& a = picture().way[i - 1];
  const procedure::Point& b = picture().way[i];
  const double share = mm[i] > mm[i - 1] ? (depth - mm[i - 1]) / (mm[i] - mm[i - 1]) : 0;
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

std::vector<QPointF> PictureView::between(double from_mm, double to_mm) const {
  std::vector<QPointF> out = {placeAt(from_mm)};
  for (std::size_t i = 0; i < picture().way.size(); ++i) {
    const double mm = picture().way_mm[i];
    if (mm > from_mm && mm < to_mm) out.emplace_back(picture().way[i].x, picture().way[i].y);
  }
  out.push_back(placeAt(to_mm));
  return out;
}

// It comes from outside, straight on from the beginning of the way; before that the tip is in front.
std::vector<QPointF> PictureView::toolTo(double depth_mm) const {
  const double begin_mm = picture().way_mm.front();
  const double outside = kOutsideShare * std::max(frame_.width(), frame_.height());
  const QPointF enters = placeAt(begin_mm);
  const QPointF inward = placeAt(begin_mm + 0.02 * (picture().way_mm.back() - begin_mm)) - enters;
  const QPointF step = inward / std::max(std::hypot(inward.x(), inward.y()), 1e-9);
  if (depth_mm <= begin_mm)
    return {enters - step * outside, enters - step * (outside * (depth_mm < begin_mm ? 0.5 : 0))};
  std::vector<QPointF> out = between(begin_mm, depth_mm);
  out.insert(out.begin(), enters - step * outside);
  return out;
}

QPixmap PictureView::drawn(const std::function<void(QPainter&)>& draw) const {
  const double ratio = devicePixelRatioF();
  QPixmap pixmap(size() * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(width() / frame_.width(), height() / frame_.height());
  painter.translate(-frame_.topLeft());
  painter.setClipRect(viewBox());  // beyond it a picture may end anyhow
  draw(painter);
  return pixmap;
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
      const auto points = between(std::max(range->from_mm, lit_->from_mm), std::min(range->to_mm, lit_->to_mm));
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

// Where a plate hides the least of the picture.
PictureView::NamePlace PictureView::placeOfName(const QPointF& at) const {
  QFont bold = font();
  bold.setBold(true);
  const QFontMetricsF metrics(bold);
  const double line = metrics.height();
  const QSizeF size(metrics.horizontalAdvance(lit_->name) + 2 * kPlatePadding * line, line * (1 + kPlatePadding));
  const QImage picture = drawing_.toImage();
  const QImage lit = lit_drawing_.toImage();
  const double ratio = drawing_.devicePixelRatio();
  const auto hidden = [&](const QRectF& box) {
    constexpr int kStepPx = 3;
    constexpr int kLitWeight = 1000;
    int count = box.contains(at) ? kLitWeight : 0;
    for (int y = static_cast<int>(box.top()); y < box.bottom(); y += kStepPx) {
      for (int x = static_cast<int>(box.left()); x < box.right(); x += kStepPx) {
        const int drawn_x = mirrored_ ? width() - 1 - x : x;
        const QPoint pixel(static_cast<int>(drawn_x * ratio), static_cast<int>(y * ratio));
        if (picture.valid(pixel) && qAlpha(picture.pixel(pixel)) > 0) ++count;
        if (lit.valid(pixel) && qAlpha(lit.pixel(pixel)) > 0) count += kLitWeight;
      }
    }
    return count;
  };
  NamePlace best;
  int least = -1;
  const double bottom = height() - kPlatePadding * line - size.height();
  for (const bool on_left : {!mirrored_, mirrored_}) {
    const double x = on_left ? kPlatePadding * line : width() - kPlatePadding * line - size.width();
    const double beside = std::clamp(at.y() - size.height() / 2, kPlatePadding * line, bottom);
    for (const double y : {bottom, beside, kPlatePadding * line}) {
      // At the top of the one side stand the small pictures of the question.
      if (on_left != mirrored_ && y < kTopShare * height()) continue;
      const int count = hidden(QRectF(QPointF(x, y), size));
      if (least >= 0 && count >= least) continue;
      least = count;
      best = {on_left, y};
    }
  }
  return best;
}

std::vector<PlateName> PictureView::plateNames() {
  std::vector<PlateName> out;
  const QTransform to_widget = toWidget();
  const auto spot = [&](const WayRange& range) {
    return to_widget.map(placeAt(range.from_mm + kNamedShare * (range.to_mm - range.from_mm)));
  };
  const bool named = lit_ && !lit_->name.isEmpty();
  if (names_shown_) {
    for (const RegionName& one : regionNames()) {
      const auto range = rangeOf(about(), one.id.toStdString());
      if (!range) continue;
      out.push_back({one.name, to_widget.map(placeAt(range->middleMm())), false, named && one.name == lit_->name, 0});
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
  if (drawing_.isNull() || drawing_.devicePixelRatio() != devicePixelRatioF()) {
    forget();
    findFrame();
    drawing_ = drawn([this](QPainter& onto) {
      QSvgRenderer renderer(bytesOf(about().files.at(picture().file)));
      renderer.setViewBox(frame_);
      renderer.render(&onto, frame_);
    });
    if (lit_) lit_drawing_ = drawn([this](QPainter& onto) { drawLit(onto); });
  }
  painter.save();
  if (mirrored_) {
    painter.translate(width(), 0);
    painter.scale(-1, 1);
  }
  painter.drawPixmap(0, 0, drawing_);
  if (lit_) painter.drawPixmap(0, 0, lit_drawing_);
  painter.restore();
  if (depth_mm_) {
    std::vector<QPointF> points = toolTo(*depth_mm_);
    const QTransform to_widget = toWidget();
    for (QPointF& point : points) point = to_widget.map(point);
    drawTool(painter, points, toolPx(), kTipPx);
  }
  painter.restore();
  painter.setRenderHint(QPainter::Antialiasing);
  drawPlates(painter, rect(), plateNames());
}

}  // namespace

BodyView* makePictureView(std::shared_ptr<const procedure::Procedure> about, QWidget* parent) {
  return new PictureView(std::move(about), parent);
}

}  // namespace tactus::workbench::anatomy
