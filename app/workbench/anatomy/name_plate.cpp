#include "app/workbench/anatomy/name_plate.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

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
    plate.box.moveTop(std::max({plate.box.top(), free_y, plate.name->least_y}));
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

}  // namespace tactus::workbench::anatomy
