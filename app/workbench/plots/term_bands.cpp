#include "app/workbench/plots/term_bands.h"

#include <QImage>
#include <QLinearGradient>
#include <QtMath>
#include <algorithm>
#include <utility>

#include "app/workbench/theme.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

constexpr double kFullAlpha = 0.13;  // of a band at membership 1; more would compete with the curves

// The places between which the membership is a straight line (for a Gaussian: nearly).
std::vector<double> corners(const fuzzy::Term& term) {
  if (term.shape != fuzzy::Shape::kGaussian) return term.points;
  std::vector<double> places;
  for (int i = -12; i <= 12; ++i) places.push_back(term.points[0] + i * term.points[1] / 4);
  return places;
}

}  // namespace

TermBands::TermBands(QCustomPlot& plot) : QCPLayerable(&plot, QStringLiteral("background")) {}

void TermBands::setTerms(const fuzzy::Variable& variable, std::vector<fuzzy::Term> terms) {
  min_ = variable.min;
  max_ = variable.max;
  terms_ = std::move(terms);
}

void TermBands::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(false); }

void TermBands::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QRectF room(area->left(), area->top(), area->width(), area->height() + 1.0);
  if (painter->modes().testFlag(QCPPainter::pmVectorized)) {
    paint(*painter, room);
    return;
  }
  // All rows are the same, so one is painted and spread over the others.
  const qreal ratio = painter->device()->devicePixelRatioF();
  QImage row(qCeil(room.width() * ratio), 1, QImage::Format_ARGB32_Premultiplied);
  row.fill(Qt::transparent);
  QPainter row_painter(&row);
  row_painter.scale(ratio, 1);
  row_painter.translate(-room.left(), 0);
  paint(row_painter, QRectF(room.left(), 0, room.width(), 1));
  row_painter.end();
  painter->drawImage(room, row);
}

void TermBands::paint(QPainter& painter, const QRectF& room) const {
  const QCPAxis* axis = mParentPlot->axisRect()->axis(QCPAxis::atBottom);
  painter.setPen(Qt::NoPen);
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    std::vector<double> places = corners(terms_[i]);
    const double low = std::clamp(places.front(), min_, max_);
    const double high = std::clamp(places.back(), min_, max_);
    if (low >= high) continue;
    const fuzzy::MembershipFunction membership = fuzzy::MembershipFunction::of(terms_[i]);
    QLinearGradient gradient(axis->coordToPixel(low), 0, axis->coordToPixel(high), 0);
    places.push_back(low);
    places.push_back(high);
    for (const double place : places) {
      const double share = (place - low) / (high - low);
      if (share < 0 || share > 1) continue;
      QColor color = theme::term(i, terms_.size());
      color.setAlphaF(static_cast<float>(kFullAlpha * membership(place)));
      gradient.setColorAt(share, color);
    }
    painter.setBrush(gradient);
    painter.drawRect(
        QRectF(QPointF(axis->coordToPixel(low), room.top()), QPointF(axis->coordToPixel(high), room.bottom())));
  }
}

}  // namespace tactus::workbench
