#include "app/workbench/plot/landmark_marks.h"

#include <QFontMetricsF>
#include <QHelpEvent>
#include <QToolTip>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/label_layout.h"

namespace tactus::workbench {
namespace {

constexpr int kNameRows = 2;
constexpr double kNameGap = 8;         // px between two names in a row
constexpr double kLandmarkBar = 3;     // px
constexpr double kReach = 5;           // px around a mark for the mouse
constexpr double kLandmarkLeader = 3;  // px from the bars to the lowest row
constexpr int kNamedFrom = 280;        // px: names would cover the lines of a lower plot; it has their numbers

}  // namespace

LandmarkMarks::LandmarkMarks(QCustomPlot& plot, Place place)
    : QCPLayerable(&plot, QStringLiteral("axes")), place_(place), font_(theme::smallFont()) {
  font_.setItalic(true);
  // Over the line of the operating point, which would run through a name.
  const auto names = QStringLiteral("names");
  if (!plot.layer(names)) plot.addLayer(names, plot.layer(QStringLiteral("overlay")), QCustomPlot::limAbove);
  setLayer(names);
  plot.installEventFilter(this);
}

void LandmarkMarks::setVariable(const fuzzy::Variable& variable, std::span<const fuzzy::TubeEvent> events) {
  landmarks_ = landmarksFor(variable, events);
}

QString LandmarkMarks::explanation() const {
  QStringList lines;
  for (const Landmark& mark : landmarks_) lines << lineOf(mark);
  return lines.join(QLatin1Char('\n'));
}

QString LandmarkMarks::lineOf(const Landmark& mark) const {
  const QString place = mark.from_mm == mark.to_mm
                            ? numberText(mark.from_mm)
                            : numberText(mark.from_mm) + QStringLiteral("–") + numberText(mark.to_mm);
  return QStringLiteral("%1  %2, %3 mm: %4 (%5)").arg(numberOf(mark), mark.name, place, mark.what, mark.source);
}

// Of the marks under the mouse at the edge where they stand; empty elsewhere.
QString LandmarkMarks::linesAt(QPointF place) const {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const bool beside = place_ == Place::kBeside;
  const QCPAxis* axis = area->axis(beside ? QCPAxis::atLeft : QCPAxis::atBottom);
  const double away = beside                     ? place.x() - area->left()
                      : place_ == Place::kInside ? area->bottom() - place.y()
                      : place_ == Place::kAbove  ? area->top() - place.y()
                                                 : place.y() - area->top();
  if (away < -kReach || away > std::max<double>(height(), kReach)) return {};
  const double at = beside ? place.y() : place.x();
  QStringList lines;
  for (const Landmark& mark : landmarks_) {
    const double from = axis->coordToPixel(mark.from_mm);
    const double to = axis->coordToPixel(mark.to_mm);
    if (at >= std::min(from, to) - kReach && at <= std::max(from, to) + kReach) lines << lineOf(mark);
  }
  return lines.join(QLatin1Char('\n'));
}

bool LandmarkMarks::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto& help = static_cast<const QHelpEvent&>(*event);
    if (const QString lines = linesAt(help.pos()); !lines.isEmpty()) {
      QToolTip::showText(help.globalPos(), lines, mParentPlot);
      return true;
    }
  }
  return QCPLayerable::eventFilter(watched, event);
}

// From 1, in the order of the way, whatever part of it is shown.
QString LandmarkMarks::numberOf(const Landmark& mark) const {
  const auto found =
      std::find_if(landmarks_.begin(), landmarks_.end(), [&](const Landmark& one) { return one.name == mark.name; });
  return QString::number(found - landmarks_.begin() + 1);
}

int LandmarkMarks::height() const {
  if (landmarks_.empty()) return 0;
  const int rows = text_ == Text::kNames ? kNameRows : text_ == Text::kNumbers ? 1 : 0;
  return static_cast<int>(kLandmarkBar + (rows > 0 ? kLandmarkLeader + rows * QFontMetricsF(font_).height() : 0)) + 1;
}

// Their parts in the range of the axis.
std::vector<Landmark> LandmarkMarks::inSight(const QCPAxis& axis) const {
  const QCPRange shown = axis.range();
  std::vector<Landmark> out;
  for (Landmark mark : landmarks_) {
    if (mark.to_mm < shown.lower || mark.from_mm > shown.upper) continue;
    mark.from_mm = std::max(mark.from_mm, shown.lower);
    mark.to_mm = std::min(mark.to_mm, shown.upper);
    out.push_back(std::move(mark));
  }
  return out;
}

void LandmarkMarks::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void LandmarkMarks::draw(QCPPainter* painter) {
  if (place_ == Place::kBeside) {
    drawBeside(*painter);
    return;
  }
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QCPAxis* axis = area->axis(QCPAxis::atBottom);
  const QFontMetricsF metrics(font_);
  // The edge on which the bars stand; under the upper one they hang.
  const bool hang = place_ == Place::kUnder;
  const double edge = place_ == Place::kAbove ? area->top() - 1.0 : hang ? area->top() + kLandmarkBar : area->bottom();
  std::vector<Label> labels;
  std::vector<Landmark> marks = inSight(*axis);
  // Names that hang end above the membership 1.
  const double free = area->axis(QCPAxis::atLeft)->coordToPixel(1) - 2 * kLandmarkLeader - edge - kLandmarkLeader;
  const bool low = place_ != Place::kAbove && area->height() < kNamedFrom;
  const bool numbers = text_ == Text::kNumbers || low || (hang && free < metrics.height());
  if (numbers) {
    for (Landmark& mark : marks) mark.name = numberOf(mark);
  }
  painter->setPen(Qt::NoPen);
  painter->setBrush(theme::mutedInk());
  for (const Landmark& mark : marks) {
    const double left = axis->coordToPixel(mark.from_mm);
    const double right = axis->coordToPixel(mark.to_mm);
    painter->drawRect(QRectF(left - 0.75, edge - kLandmarkBar, std::max(1.5, right - left), kLandmarkBar));
    labels.push_back({(left + right) / 2, metrics.horizontalAdvance(mark.name)});
  }
  if (text_ == Text::kNone) return;

  const QRect room = place_ == Place::kAbove ? mParentPlot->viewport() : area->rect();
  // A number has nothing below its line, and comes closer to the handles.
  const bool close = hang && numbers;
  const double row_height = close ? metrics.ascent() : metrics.height();
  const double room_down = close ? free + kLandmarkLeader : free;
  const int rows = hang ? std::clamp(static_cast<int>(room_down / row_height), 0, kNameRows) : kNameRows;
  const auto places = placeLabels(labels, rows, room.left() + 2.0, room.right() - 2.0, kNameGap);
  painter->setFont(font_);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (!places[i]) continue;
    const double away = kLandmarkLeader + places[i]->row * row_height;
    const double base = hang ? edge + away + row_height : edge - kLandmarkBar - away;
    painter->setPen(QPen(theme::mutedInk(), 0.8));
    painter->drawLine(QLineF(lineStart(labels[i], *places[i]), hang ? edge + away : base, labels[i].center,
                             hang ? edge : edge - kLandmarkBar));
    QColor halo = theme::card();
    halo.setAlphaF(0.75F);
    painter->fillRect(QRectF(places[i]->left - 2, base - row_height, labels[i].width + 4, row_height), halo);
    painter->setPen(theme::mutedInk());
    painter->drawText(QPointF(places[i]->left, base - (close ? 1 : metrics.descent())), marks[i].name);
  }
}

void LandmarkMarks::drawBeside(QCPPainter& painter) const {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QCPAxis* axis = area->axis(QCPAxis::atLeft);
  const QFontMetricsF metrics(font_);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::ink());
  // From the top of the screen down, which is from the deepest up.
  std::vector<Label> labels;
  const std::vector<Landmark> marks = inSight(*axis);
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
    const double low = axis->coordToPixel(mark->from_mm);
    const double high = axis->coordToPixel(mark->to_mm);
    painter.drawRect(QRectF(area->left(), high - 0.75, kLandmarkBar, std::max(1.5, low - high)));
    labels.push_back({(low + high) / 2, metrics.height()});
  }
  const auto places = placeLabels(labels, 1, area->top(), area->bottom(), 0);
  painter.setFont(font_);
  QColor halo = theme::card();
  halo.setAlphaF(0.75F);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!places[i]) continue;
    const QString& name = marks[marks.size() - 1 - i].name;
    const double left = area->left() + kLandmarkBar + 3 * kLandmarkLeader;
    const double top = places[i]->left;
    painter.setPen(QPen(theme::ink(), 0.8));
    painter.drawLine(QLineF(area->left() + kLandmarkBar, labels[i].center, left - 2, top + metrics.height() / 2));
    painter.fillRect(QRectF(left - 2, top, metrics.horizontalAdvance(name) + 4, metrics.height()), halo);
    painter.setPen(theme::ink());
    painter.drawText(QPointF(left, top + metrics.ascent()), name);
  }
}

}  // namespace tactus::workbench
