#include "app/workbench/understand/map/map_marks.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cstdint>
#include <utility>

#include "app/workbench/base/theme.h"
#include "app/workbench/plot/label_board.h"

namespace tactus::workbench {
namespace {

constexpr double kSquare = 8;  // px, of the grid in which lines and numbers are kept apart

}  // namespace

ContourMarks::ContourMarks(QCustomPlot& plot) : QCPLayerable(&plot, QStringLiteral("main")) {}

void ContourMarks::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void ContourMarks::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QCPAxis* bottom = area->axis(QCPAxis::atBottom);
  const QCPAxis* left = area->axis(QCPAxis::atLeft);
  QColor color = Qt::white;  // on the colors of the map, whatever the theme
  color.setAlphaF(0.65F);
  painter->setPen(QPen(color, 1));
  std::vector<QVector<QLineF>> all;
  for (const Line& line : lines_) {
    QVector<QLineF>& pieces = all.emplace_back();
    pieces.reserve(static_cast<qsizetype>(line.pieces.size()));
    for (const QLineF& piece : line.pieces) {
      pieces << QLineF(bottom->coordToPixel(piece.x1()), left->coordToPixel(piece.y1()),
                       bottom->coordToPixel(piece.x2()), left->coordToPixel(piece.y2()));
    }
    painter->drawLines(pieces);
  }
  if (labelled_) drawLabels(*painter, all);
}

void ContourMarks::drawLabels(QCPPainter& painter, const std::vector<QVector<QLineF>>& pieces) const {
  const QFont font = theme::smallFont();
  const QFontMetricsF metrics(font);
  const QRectF area = mParentPlot->axisRect()->rect();
  // Which lines run through each square of the map, one bit for each.
  const int columns = static_cast<int>(area.width() / kSquare) + 1;
  const int rows = static_cast<int>(area.height() / kSquare) + 1;
  std::vector<std::uint32_t> lines_in(static_cast<std::size_t>(columns * rows), 0);
  const auto square = [&](const QPointF& at) {
    const int column = std::clamp(static_cast<int>((at.x() - area.left()) / kSquare), 0, columns - 1);
    const int row = std::clamp(static_cast<int>((at.y() - area.top()) / kSquare), 0, rows - 1);
    return static_cast<std::size_t>(row * columns + column);
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const QLineF& piece : pieces[i]) {
      lines_in[square(piece.p1())] |= 1U << i % 32;
      lines_in[square(piece.p2())] |= 1U << i % 32;
    }
  }
  LabelBoard board(area.adjusted(2, 2, -2, -2));
  painter.setFont(font);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const QSizeF size(metrics.horizontalAdvance(lines_[i].text) + 6, metrics.height());
    const qsizetype count = pieces[i].size();
    // From the middle of the line outward.
    for (qsizetype step = 0; step < count; ++step) {
      const QPointF at = pieces[i][(count / 2 + (step % 2 == 0 ? step / 2 : count - 1 - step / 2)) % count].center();
      std::uint32_t lines = 0;
      for (double y = -size.height() / 2; y <= size.height() / 2; y += size.height() / 2) {
        for (double x = -size.width() / 2; x <= size.width() / 2; x += size.width() / 4) {
          lines |= lines_in[square(at + QPointF(x, y))];
        }
      }
      if ((lines & ~(1U << i % 32)) != 0 || !board.place({at, size, 0})) continue;
      const QRectF box(at - QPointF(size.width() / 2, size.height() / 2), size);
      painter.setPen(Qt::NoPen);
      painter.setBrush(lines_[i].ground);
      painter.drawRoundedRect(box, 3, 3);
      painter.setPen(Qt::white);
      painter.drawText(box, Qt::AlignCenter, lines_[i].text);
      break;
    }
  }
}

// The overlay has a buffer of its own, so the cross moves without drawing the map again.
MapCross::MapCross(QCustomPlot& plot) : QCPLayerable(&plot, QStringLiteral("overlay")), font_(theme::smallFont()) {}

void MapCross::set(double x, double y, QString tag) {
  x_ = x;
  y_ = y;
  tag_ = std::move(tag);
}

void MapCross::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void MapCross::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QPointF place(area->axis(QCPAxis::atBottom)->coordToPixel(x_), area->axis(QCPAxis::atLeft)->coordToPixel(y_));
  QColor line = Qt::white;
  line.setAlphaF(0.9F);
  for (const QPen& pen : {QPen(theme::accent(), 2.6), QPen(line, 1)}) {
    painter->setPen(pen);
    painter->drawLine(QLineF(place.x(), area->top(), place.x(), area->bottom()));
    painter->drawLine(QLineF(area->left(), place.y(), area->right(), place.y()));
  }
  painter->setPen(QPen(Qt::white, 1.5));
  painter->setBrush(theme::accent());
  painter->drawEllipse(place, 4.5, 4.5);

  const QFontMetricsF metrics(font_);
  const double width = metrics.horizontalAdvance(tag_) + 12;
  const double height = metrics.height() + 6;
  // In a narrow map neither side has room; the names of the axis stay readable.
  const double left =
      place.x() + 8 + width <= area->right() ? place.x() + 8 : std::max<double>(area->left(), place.x() - 8 - width);
  const double top = place.y() - 8 - height >= area->top() ? place.y() - 8 - height : place.y() + 8;
  painter->setPen(Qt::NoPen);
  painter->setBrush(theme::accent());
  painter->drawRoundedRect(QRectF(left, top, width, height), 4, 4);
  painter->setPen(Qt::white);
  painter->setFont(font_);
  painter->drawText(QPointF(left + 6, top + height - 3 - metrics.descent()), tag_);
}

}  // namespace tactus::workbench
