#include "app/workbench/plots/landmark_marks.h"

#include <QFontMetricsF>
#include <algorithm>

#include "app/workbench/display_text.h"
#include "app/workbench/plots/label_layout.h"
#include "app/workbench/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kRows = 2;
constexpr double kGap = 8;     // px between two names in a row
constexpr double kBar = 3;     // px
constexpr double kLeader = 3;  // px from the bars to the lowest row

}  // namespace

LandmarkMarks::LandmarkMarks(QCustomPlot& plot, Place place)
    : QCPLayerable(&plot, QStringLiteral("axes")), place_(place), font_(theme::smallFont()) {
  font_.setItalic(true);
}

void LandmarkMarks::setVariable(const fuzzy::Variable& variable) { landmarks_ = landmarksFor(variable); }

QString LandmarkMarks::explanation() const {
  QStringList lines;
  for (const Landmark& mark : landmarks_) {
    const QString place = mark.from_mm == mark.to_mm
                              ? numberText(mark.from_mm)
                              : numberText(mark.from_mm) + QStringLiteral("–") + numberText(mark.to_mm);
    lines << QStringLiteral("%1, %2 mm: %3 (%4)").arg(mark.name, place, mark.what, mark.source);
  }
  return lines.join(QLatin1Char('\n'));
}

int LandmarkMarks::height() const {
  return landmarks_.empty() ? 0 : static_cast<int>(kBar + kLeader + kRows * QFontMetricsF(font_).height()) + 1;
}

void LandmarkMarks::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void LandmarkMarks::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QCPAxis* axis = area->axis(QCPAxis::atBottom);
  const QFontMetricsF metrics(font_);
  // The edge on which the bars stand.
  const double bottom = place_ == Place::kAbove ? area->top() - 1.0 : area->bottom();
  std::vector<Label> labels;
  painter->setPen(Qt::NoPen);
  painter->setBrush(theme::mutedInk());
  for (const Landmark& mark : landmarks_) {
    const double left = axis->coordToPixel(mark.from_mm);
    const double right = axis->coordToPixel(mark.to_mm);
    painter->drawRect(QRectF(left - 0.75, bottom - kBar, std::max(1.5, right - left), kBar));
    labels.push_back({(left + right) / 2, metrics.horizontalAdvance(mark.name)});
  }
  if (place_ == Place::kBars) return;

  const QRect room = place_ == Place::kAbove ? mParentPlot->viewport() : area->rect();
  const auto places = placeLabels(labels, kRows, room.left() + 2.0, room.right() - 2.0, kGap);
  painter->setFont(font_);
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    if (!places[i]) continue;
    const double base = bottom - kBar - kLeader - places[i]->row * metrics.height();
    painter->setPen(QPen(theme::mutedInk(), 0.8));
    painter->drawLine(QLineF(lineStart(labels[i], *places[i]), base, labels[i].center, bottom - kBar));
    QColor halo = theme::card();
    halo.setAlphaF(0.75F);
    painter->fillRect(QRectF(places[i]->left - 2, base - metrics.height(), labels[i].width + 4, metrics.height()),
                      halo);
    painter->setPen(theme::mutedInk());
    painter->drawText(QPointF(places[i]->left, base - metrics.descent()), landmarks_[i].name);
  }
}

}  // namespace tactus::workbench
