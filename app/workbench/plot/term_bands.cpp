#include "app/workbench/plot/term_bands.h"

#include <QImage>
#include <QLinearGradient>
#include <QtMath>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/plot/term_colors.h"

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

void TermBands::setTerms(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  min_ = variable.min;
  max_ = variable.max;
  terms_.clear();
  colors_.clear();
  places_ = {min_, max_};
  // On both sides of a vertical edge, as near as a gradient can tell apart.
  const double beside = 1e-6 * (max_ - min_);
  for (std::size_t i = 0; i < terms.size(); ++i) colors_.push_back(termFill(variable, terms, i));
  for (const fuzzy::Term& term : terms) {
    terms_.push_back(fuzzy::MembershipFunction::of(term));
    for (const double corner : corners(term)) {
      for (const double place : {corner - beside, corner, corner + beside}) {
        if (place > min_ && place < max_) places_.push_back(place);
      }
    }
  }
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

// One opaque gradient over the whole axis: pages of a PDF have no transparent ones.
void TermBands::paint(QPainter& painter, const QRectF& room) const {
  if (terms_.empty()) return;
  const QCPAxis* axis = mParentPlot->axisRect()->axis(QCPAxis::atBottom);
  const double left = axis->coordToPixel(min_);
  const double right = axis->coordToPixel(max_);
  QLinearGradient gradient(left, 0, right, 0);
  for (const double place : places_) gradient.setColorAt((place - min_) / (max_ - min_), colorAt(place));
  painter.setPen(Qt::NoPen);
  painter.setBrush(gradient);
  painter.drawRect(
      QRectF(QPointF(std::max(left, room.left()), room.top()), QPointF(std::min(right, room.right()), room.bottom())));
}

QColor TermBands::colorAt(double place) const {
  QColor color = theme::card();
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    color = mixedColor(color, colors_[i], kFullAlpha * terms_[i](place));
  }
  return color;
}

}  // namespace tactus::workbench
