#include "app/workbench/plots/term_bands.h"

#include <QLinearGradient>
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
  const QCPAxis* axis = area->axis(QCPAxis::atBottom);
  painter->setPen(Qt::NoPen);
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
    painter->setBrush(gradient);
    painter->drawRect(
        QRectF(QPointF(axis->coordToPixel(low), area->top()), QPointF(axis->coordToPixel(high), area->bottom() + 1.0)));
  }
}

}  // namespace tactus::workbench
