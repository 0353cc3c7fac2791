#include "app/workbench/anatomy/anatomy_drawing.h"

#include <QByteArray>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <algorithm>
#include <array>
#include <string_view>

#include "app/workbench/anatomy/anatomy.h"
#include "core/base/check.h"

namespace tactus::workbench::anatomy {

std::string_view uprightDrawing();
std::string_view halfFlexedDrawing();
std::string_view chinOnChestDrawing();

namespace {

constexpr std::size_t kKeptPixmaps = 6;
constexpr QRectF kWhole(-152, -168, 412, 620);
// Head and neck of the three postures.
constexpr std::array kHeadAndNeck = {QRectF(-42, -66, 200, 250), QRectF(-80, -25, 200, 250), QRectF(-90, 5, 200, 250)};

std::string_view fileOf(Posture posture) {
  switch (posture) {
    case Posture::kUpright: return uprightDrawing();
    case Posture::kHalfFlexed: return halfFlexedDrawing();
    case Posture::kChinOnChest: break;
  }
  return chinOnChestDrawing();
}

// The drawing ends with a tube down to the stomach, which is left out.
QByteArray withoutTube(std::string_view file) {
  const auto begin = file.find("<g id=\"tube\">");
  const auto end = file.find("</svg>");
  TACTUS_CHECK(begin != std::string_view::npos && end != std::string_view::npos && begin < end);
  QByteArray drawing(file.data(), static_cast<qsizetype>(begin));
  drawing.append(file.data() + end, static_cast<qsizetype>(file.size() - end));
  return drawing;
}

// The way `d` of a path of the drawing: M, C, L and Z with absolute numbers.
QPainterPath readPath(const QString& d) {
  static const QRegularExpression kPiece(QStringLiteral("([MCLZ])([^MCLZ]*)"));
  static const QRegularExpression kNumber(QStringLiteral("-?[0-9.]+"));
  QPainterPath path;
  for (auto piece = kPiece.globalMatch(d); piece.hasNext();) {
    const QRegularExpressionMatch match = piece.next();
    std::vector<QPointF> points;
    for (auto number = kNumber.globalMatch(match.captured(2)); number.hasNext();) {
      const double x = number.next().captured().toDouble();
      TACTUS_CHECK(number.hasNext());
      points.emplace_back(x, number.next().captured().toDouble());
    }
    switch (match.captured(1).at(0).toLatin1()) {
      case 'M': path.moveTo(points.at(0)); break;
      case 'L':
        for (const QPointF& point : points) path.lineTo(point);
        break;
      case 'C':
        for (std::size_t i = 0; i + 2 < points.size(); i += 3) path.cubicTo(points[i], points[i + 1], points[i + 2]);
        break;
      default: path.closeSubpath();
    }
  }
  return path;
}

// Around the tip of the nose, the roof of its cavity, the chin, the back of the spine and the upper sphincter.
QRectF throatIn(Posture posture) {
  constexpr double kMarginMm = 12;
  constexpr struct {
    QPointF at;
    Part part;
  } kCorners[] = {{{-16, -3}, Part::kHead},
                  {{26, -46}, Part::kHead},
                  {{8, 66}, Part::kHead},
                  {{116, 60}, Part::kSoft},
                  {{104, 114}, Part::kSoft}};
  QPolygonF corners;
  for (const auto& corner : kCorners) corners << posed(corner.at, corner.part, drawnFlexionDeg(posture));
  return corners.boundingRect().adjusted(-kMarginMm, -kMarginMm, kMarginMm, kMarginMm);
}

}  // namespace

QRectF frameOf(Framing framing, Posture posture, const QSizeF& size) {
  QRectF frame = kHeadAndNeck[static_cast<std::size_t>(posture)];
  if (framing == Framing::kWhole) frame = kWhole;
  if (framing == Framing::kThroat) frame = throatIn(posture);
  const double wide = frame.height() * size.width() / size.height() - frame.width();
  const double high = frame.width() * size.height() / size.width() - frame.height();
  if (wide > 0) return frame.adjusted(-wide / 2, 0, wide / 2, 0);
  return frame.adjusted(0, -high / 2, 0, high / 2);
}

QPainterPath outlineOf(Region region, Posture posture) {
  const std::string_view file = fileOf(posture);
  const auto element = file.find("id=\"region_" + std::string(idOf(region)) + "\"");
  TACTUS_CHECK(element != std::string_view::npos);
  const auto begin = file.find(" d=\"", element) + 4;
  const auto end = file.find('"', begin);
  return readPath(QString::fromLatin1(file.data() + begin, static_cast<qsizetype>(end - begin)));
}

QPixmap AnatomyDrawing::pixmap(Posture posture, Framing framing, const QSize& size, double ratio) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) {
    return kept.posture == posture && kept.framing == framing && kept.size == size && kept.ratio == ratio;
  });
  if (found != kept_.end()) return found->pixmap;

  QPixmap pixmap(size * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QSvgRenderer renderer(withoutTube(fileOf(posture)));
  renderer.setViewBox(frameOf(framing, posture, size));
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  renderer.render(&painter, QRectF(QPointF(), size));
  painter.end();

  kept_.push_front({posture, framing, size, ratio, pixmap});
  if (kept_.size() > kKeptPixmaps) kept_.pop_back();
  return pixmap;
}

}  // namespace tactus::workbench::anatomy
