#include <QFontMetricsF>
#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/anatomy/solid.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench::anatomy {

namespace {

constexpr int kBodyCells = 84;
constexpr int kRegionCells = 26;
constexpr double kBeforeWayShare = 0.1;  // of the longer side of a picture: the tool before its way
constexpr double kBodyMargin = 0.05;     // of a view, around the body
constexpr double kToolShare = 0.016;     // of the shorter side of a view
constexpr double kMostToolPx = 9;
constexpr double kTipDotPx = 5;
constexpr double kLinePx = 1.4;
constexpr double kRegionLinePx = 0.9;
constexpr double kDegreesOfPx = 0.5;
constexpr double kDegreesOfKey = 5;
constexpr double kMostPitchDeg = 85;
constexpr std::uint32_t kRgb = 0x00FFFFFF;

constexpr QColor kLine(0xB0, 0x82, 0x6A);
constexpr SolidColors kSkin{0xF4D9CB, 0xC08F78, 0.34, 0.9};
constexpr SolidColors kRegion{0xE9A79B, 0x9C5A50, 0.5, 0.95};
constexpr QColor kRegionLine(0x9C, 0x5A, 0x50);

/// The pictures from which the body can be made.
std::vector<procedure::Picture> solidPictures(const procedure::Procedure& about) {
  std::vector<procedure::Picture> out;
  for (const procedure::Picture& picture : about.pictures) {
    if (!picture.outline.empty()) out.push_back(picture);
  }
  return out;
}

SolidColors litColors() {
  const QColor dark = kLit.darker(150);
  return {kLit.rgb() & kRgb, dark.rgb() & kRgb, 0.8, 1};
}

Turn firstTurn(procedure::FrontSide front) {
  switch (front) {
    case procedure::FrontSide::kLeft: return {42, 12};
    case procedure::FrontSide::kRight: return {-42, 12};
    case procedure::FrontSide::kTop: return {-24, 32};
    case procedure::FrontSide::kBottom: break;
  }
  return {-24, -32};
}

}  // namespace

/// The body, and its three views.
class SolidView::Scene {
 public:
  enum View : std::uint8_t { kSide, kFront, kTurned };

  /// The procedure has a picture with an outline.
  explicit Scene(const procedure::Procedure& about)
      : about_(about), pictures_(solidPictures(about)), shown_(pictures_.size()) {}

  /// Shows the picture of the pose, or that of the usual one.
  void setPose(const study::ItemCondition& condition) {
    const auto found = std::find_if(pictures_.begin(), pictures_.end(),
                                    [&](const procedure::Picture& picture) { return picture.pose == condition; });
    const auto shown = found == pictures_.end() ? std::size_t{0} : static_cast<std::size_t>(found - pictures_.begin());
    if (shown == shown_) return;
    const bool first = shown_ == pictures_.size();
    shown_ = shown;
    blowUp();
    if (first) turnBack();
  }

  /// Another region is lit: the body stays as it is drawn.
  void forgetRegions() {
    for (Pane& pane : panes_) pane.drawing = {};
  }
  const Turn& turned() const { return panes_[kTurned].turn; }
  void setTurn(const Turn& turn) {
    panes_[kTurned].turn = turn;
    panes_[kTurned].forget();
  }
  void turnBack() { setTurn(firstTurn(picture().front)); }
  const QRectF& place(View view) const { return panes_[view].place; }

  /// Ready to be painted in a widget of this size.
  void prepare(const QSize& size, double ratio, const std::optional<LitRange>& lit) {
    if (size != placed_) arrange(size);
    for (Pane& pane : panes_) {
      if (!pane.drawing.isNull() && pane.drawing.devicePixelRatio() != ratio) pane.forget();
      if (pane.drawing.isNull()) pane.drawing = drawn(pane, ratio, lit);
    }
  }

  void paint(QPainter& painter, double depth_mm, const std::optional<QColor>& tip) const {
    const std::vector<Spot> tool = toolAt(depth_mm);
    for (const Pane& pane : panes_) {
      painter.drawPixmap(pane.place.topLeft(), pane.drawing);
      painter.save();
      painter.setClipRect(pane.place, Qt::IntersectClip);
      std::vector<QPointF> points;
      for (const Spot& spot : tool) points.push_back(inWidget(pane, spot));
      const double width = std::min(kMostToolPx, kToolShare * std::min(pane.place.width(), pane.place.height()));
      drawTool(painter, points, width, kTipDotPx);
      if (tip) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(*tip);
        painter.drawEllipse(points.back(), kTipDotPx - 1, kTipDotPx - 1);
      }
      painter.restore();
    }
  }

  QPointF inSideView(double place_mm) const { return inWidget(panes_[kSide], wayAt(picture(), place_mm)); }

 private:
  struct Part {
    std::string region;
    Solid solid;
  };
  struct Pane {
    Turn turn;
    QRectF place;      ///< in the widget
    double scale = 1;  ///< px of a unit
    QPixmap drawing;   ///< without the tool
    // The body alone, which takes the longest to draw.
    std::optional<Canvas> body = {};
    QImage contour = {};

    void forget() {
      drawing = {};
      body.reset();
    }
  };

  const procedure::Picture& picture() const { return pictures_[shown_]; }

  void blowUp() {
    const Frame frame = frameOf(picture());
    body_ = solidOf(picture().outline, frame, picture().breadth, kBodyCells);
    parts_.clear();
    for (const auto& [id, path] : picture().regions) {
      Part part{id, solidOf(procedure::pointsOf(path), frame, std::nullopt, kRegionCells)};
      if (const auto range = rangeOf(about_, id)) {
        const double across = wayAt(picture(), range->middleMm()).z;
        for (Solid::Vertex& vertex : part.solid.vertices) vertex.at.z += across;
      }
      parts_.push_back(std::move(part));
    }
    panes_[kFront].turn = frontTurn(picture().front);
    // What is to be seen: the body, and the tool before it.
    low_ = high_ = toolAt(picture().way_mm.front()).front();
    for (const Solid::Vertex& vertex : body_.vertices) {
      low_ = {std::min(low_.x, vertex.at.x), std::min(low_.y, vertex.at.y), std::min(low_.z, vertex.at.z)};
      high_ = {std::max(high_.x, vertex.at.x), std::max(high_.y, vertex.at.y), std::max(high_.z, vertex.at.z)};
    }
    placed_ = {};
  }

  std::vector<Spot> toolAt(double depth_mm) const {
    return toolTo(picture(), depth_mm, kBeforeWayShare * std::max(picture().width, picture().height));
  }

  /// Width and height of what `view` has to show, in units of the picture.
  QSizeF extent(View view) const {
    const double x = high_.x - low_.x, y = high_.y - low_.y, z = high_.z - low_.z;
    constexpr double kDepthShare =
        0.4;  // of the depth, that comes into sight when the body is turned toward the viewer
    const bool beside =
        picture().front == procedure::FrontSide::kLeft || picture().front == procedure::FrontSide::kRight;
    if (view == kSide) return {x, y};
    if (view == kFront) return beside ? QSizeF(z, y) : QSizeF(x, z);
    return {std::hypot(x, z), std::hypot(y, kDepthShare * std::max(x, z))};
  }

  double scaleIn(View view, const QRectF& place) const {
    const QSizeF size = extent(view);
    return (1 - 2 * kBodyMargin) * std::min(place.width() / size.width(), place.height() / size.height());
  }

  /// The three views in one row, in one column, or two beside or above the third: where the body is largest.
  void arrange(const QSize& size) {
    const double w = size.width(), h = size.height();
    const std::array<std::array<QRectF, 3>, 4> ways = {{
        {QRectF(0, 0, w / 3, h), QRectF(w / 3, 0, w / 3, h), QRectF(2 * w / 3, 0, w / 3, h)},
        {QRectF(0, 0, w, h / 3), QRectF(0, h / 3, w, h / 3), QRectF(0, 2 * h / 3, w, h / 3)},
        {QRectF(0, 0, w / 2, h / 2), QRectF(w / 2, 0, w / 2, h / 2), QRectF(0, h / 2, w, h / 2)},
        {QRectF(0, 0, w / 2, h / 2), QRectF(0, h / 2, w / 2, h / 2), QRectF(w / 2, 0, w / 2, h)},
    }};
    const auto smallest = [this](const std::array<QRectF, 3>& places) {
      return std::min(
          {scaleIn(kSide, places[kSide]), scaleIn(kFront, places[kFront]), scaleIn(kTurned, places[kTurned])});
    };
    const auto& best = *std::max_element(ways.begin(), ways.end(),
                                         [&](const auto& a, const auto& b) { return smallest(a) < smallest(b); });
    // Side and front are as large as each other.
    const double scale = std::min(scaleIn(kSide, best[kSide]), scaleIn(kFront, best[kFront]));
    for (const View view : {kSide, kFront, kTurned}) {
      Pane& pane = panes_[view];
      pane.place = best[view].toAlignedRect().intersected(QRect(QPoint(), size));
      pane.scale = view == kTurned ? scaleIn(view, best[view]) : scale;
      pane.forget();
    }
    placed_ = size;
  }

  Projection projection(const Pane& pane, const QPointF& middle, double scale) const {
    const Spot center{(low_.x + high_.x) / 2, (low_.y + high_.y) / 2, 0};
    return {pane.turn, center, pane.scale * scale, middle.x(), middle.y()};
  }

  QPointF inWidget(const Pane& pane, const Spot& spot) const {
    const Spot at = projection(pane, pane.place.center(), 1)(spot);
    return {at.x, at.y};
  }

  static void drawLines(QPainter& painter, const std::vector<ContourLine>& pieces, QColor color, double width) {
    QList<QLineF> whole;
    for (const ContourLine& piece : pieces) {
      if (piece.seen >= 1) {
        whole << QLineF(piece.x1, piece.y1, piece.x2, piece.y2);
        continue;
      }
      QColor faded = color;
      faded.setAlphaF(static_cast<float>(piece.seen));
      painter.setPen(QPen(faded, width, Qt::SolidLine, Qt::FlatCap));
      painter.drawLine(QPointF(piece.x1, piece.y1), QPointF(piece.x2, piece.y2));
    }
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLines(whole);
  }

  static QImage imageOf(const Canvas& canvas) {
    return {reinterpret_cast<const uchar*>(canvas.pixels.data()), canvas.width, canvas.height,
            QImage::Format_ARGB32_Premultiplied};
  }

  QPixmap drawn(Pane& pane, double ratio, const std::optional<LitRange>& range) const {
    const QSize size = (pane.place.size() * ratio).toSize();
    QPixmap out(size);
    out.fill(theme::card());
    if (size.isEmpty()) return out;
    const Projection to_canvas = projection(pane, QPointF(size.width(), size.height()) / 2, ratio);
    if (!pane.body) {
      pane.body.emplace(size.width(), size.height());
      const auto pieces = drawSolid(*pane.body, body_, to_canvas, kSkin);
      pane.contour = QImage(size, QImage::Format_ARGB32_Premultiplied);
      pane.contour.fill(Qt::transparent);
      QPainter painter(&pane.contour);
      painter.setRenderHint(QPainter::Antialiasing);
      drawLines(painter, pieces, kLine, kLinePx * ratio);
    }
    Canvas canvas = *pane.body;
    struct Lines {
      std::vector<ContourLine> pieces;
      QColor color;
    };
    std::vector<Lines> lines;
    for (const Part& part : parts_) {
      const auto own = rangeOf(about_, part.region);
      const bool shines = range && own && own->middleMm() >= range->from_mm && own->middleMm() < range->to_mm;
      lines.push_back(
          {drawSolid(canvas, part.solid, to_canvas, shines ? litColors() : kRegion), shines ? kLitEdge : kRegionLine});
    }
    QPainter painter(&out);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawImage(0, 0, imageOf(canvas));
    painter.drawImage(0, 0, pane.contour);
    for (const Lines& of : lines) drawLines(painter, of.pieces, of.color, kRegionLinePx * ratio);
    painter.end();
    out.setDevicePixelRatio(ratio);
    return out;
  }

  const procedure::Procedure& about_;
  std::vector<procedure::Picture> pictures_;
  std::size_t shown_;  ///< of them; none before the first pose
  Solid body_;
  std::vector<Part> parts_;  ///< the regions
  Spot low_, high_;          ///< the corners of what is to be seen
  std::array<Pane, 3> panes_;
  QSize placed_;  ///< of the widget
};

SolidView::SolidView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("The body in three dimensions, with the tool on its way"));
  setToolTip(tr("Drag the third view or press the arrow keys to turn it; a double click or Home turns it back"));
}

SolidView::~SolidView() = default;

QString SolidView::missing(const procedure::Procedure* about) {
  if (about == nullptr) return tr("There is no 3-D view: the procedure of this model is not known here.");
  if (about->pictures.empty()) return tr("There is no 3-D view: this procedure has no picture of the body.");
  const bool any = std::any_of(about->pictures.begin(), about->pictures.end(),
                               [](const procedure::Picture& picture) { return !picture.outline.empty(); });
  return any ? QString() : tr("There is no 3-D view: no picture of this procedure has an outline of the whole body.");
}

void SolidView::setAbout(std::shared_ptr<const procedure::Procedure> about) {
  if (about == about_) return;
  about_ = std::move(about);
  scene_.reset();
  update();
}

void SolidView::setPose(const study::ItemCondition& condition) {
  if (condition == pose_) return;
  pose_ = condition;
  update();
}

void SolidView::setDepth(double depth_mm) {
  constexpr double kDrawnMm = 0.1;
  if (std::abs(depth_mm - depth_mm_) < kDrawnMm) return;
  depth_mm_ = depth_mm;
  update();
}

void SolidView::light(const std::optional<LitRange>& range) {
  if (lit_ == range) return;
  lit_ = range;
  if (scene_ != nullptr) scene_->forgetRegions();
  update();
}

void SolidView::setFelt(const std::optional<FeltForce>& felt) {
  if (felt_ == felt) return;
  felt_ = felt;
  update();
}

void SolidView::paintEvent(QPaintEvent* /*event*/) {
  if (width() < 2 || height() < 2 || !missing(about_.get()).isEmpty()) return;
  if (scene_ == nullptr) scene_ = std::make_unique<Scene>(*about_);
  scene_->setPose(pose_);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath corners;
  corners.addRoundedRect(rect(), theme::kCornerRadius, theme::kCornerRadius);
  painter.setClipPath(corners);
  scene_->prepare(size(), devicePixelRatioF(), lit_);
  scene_->paint(painter, depth_mm_, felt_ ? std::optional(felt_->color) : std::nullopt);
  drawNotes(painter);
}

void SolidView::drawNotes(QPainter& painter) const {
  const QFontMetricsF metrics(font());
  const double line = metrics.height();
  const double inset = line / 3;
  painter.setFont(font());
  const std::pair<Scene::View, QString> titles[] = {
      {Scene::kSide, tr("From the side")}, {Scene::kFront, tr("From the front")}, {Scene::kTurned, tr("Turned")}};
  for (const auto& [view, title] : titles) {
    const QRectF place = scene_->place(view);
    painter.setPen(QPen(theme::border(), 1));
    if (place.left() > 0) painter.drawLine(place.topLeft(), place.bottomLeft());
    if (place.top() > 0) painter.drawLine(place.topLeft(), place.topRight());
    painter.setPen(theme::mutedInk());
    painter.drawText(place.adjusted(inset, inset, -inset, 0), Qt::AlignLeft | Qt::AlignTop,
                     metrics.elidedText(title, Qt::ElideRight, place.width() - 2 * inset));
  }
  const QRectF foot = QRectF(rect()).adjusted(inset, 0, -inset, -inset);
  painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom, tr("schematic"));
  if (lit_ && !lit_->name.isEmpty()) {
    const QRectF side = scene_->place(Scene::kSide);
    drawPlates(painter, side.adjusted(0, line, 0, 0),
               {{lit_->name, scene_->inSideView((lit_->from_mm + lit_->to_mm) / 2), false, true}});
  }
  if (felt_) {
    const QRectF turned = scene_->place(Scene::kTurned);
    const double square = metrics.ascent();
    const QRectF plate(
        turned.left() + inset, turned.bottom() - inset - 1.5 * line,
        std::min(metrics.horizontalAdvance(felt_->text) + square + 3 * inset, turned.width() - 2 * inset), 1.5 * line);
    painter.setPen(QPen(theme::border(), 1));
    painter.setBrush(theme::card());
    painter.drawRoundedRect(plate, inset, inset);
    painter.fillRect(QRectF(plate.left() + inset, plate.center().y() - square / 2, square, square), felt_->color);
    painter.setPen(theme::ink());
    painter.drawText(plate.adjusted(square + 2 * inset, 0, -inset, 0), Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(felt_->text, Qt::ElideRight, plate.width() - square - 3 * inset));
  }
  if (hasFocus()) {
    painter.setPen(QPen(theme::accent(), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), theme::kCornerRadius, theme::kCornerRadius);
  }
}

void SolidView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && scene_ != nullptr) scene_->forgetRegions();
  QWidget::changeEvent(event);
}

void SolidView::turn(double yaw_deg, double pitch_deg) {
  if (scene_ == nullptr) return;
  const Turn& now = scene_->turned();
  scene_->setTurn({std::remainder(now.yaw_deg + yaw_deg, 360),
                   std::clamp(now.pitch_deg + pitch_deg, -kMostPitchDeg, kMostPitchDeg)});
  update();
}

void SolidView::mousePressEvent(QMouseEvent* event) { dragged_from_ = event->position(); }

void SolidView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF way = event->position() - std::exchange(dragged_from_, event->position());
  if (event->buttons().testFlag(Qt::LeftButton)) turn(kDegreesOfPx * way.x(), kDegreesOfPx * way.y());
}

void SolidView::mouseDoubleClickEvent(QMouseEvent* /*event*/) { turnBack(); }

void SolidView::turnBack() {
  if (scene_ != nullptr) scene_->turnBack();
  update();
}

void SolidView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left: return turn(-kDegreesOfKey, 0);
    case Qt::Key_Right: return turn(kDegreesOfKey, 0);
    case Qt::Key_Up: return turn(0, -kDegreesOfKey);
    case Qt::Key_Down: return turn(0, kDegreesOfKey);
    case Qt::Key_Home: return turnBack();
    default: QWidget::keyPressEvent(event);
  }
}

}  // namespace tactus::workbench::anatomy
