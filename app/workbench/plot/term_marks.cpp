#include "app/workbench/plot/term_marks.h"

#include <QFontMetricsF>
#include <QImage>
#include <QLinearGradient>
#include <QtMath>
#include <algorithm>
#include <cstdint>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/plot/label_layout.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

figures::Rgb rgbOf(const QColor& color) {
  return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
          static_cast<std::uint8_t>(color.blue())};
}

}  // namespace

QColor mixedColor(const QColor& from, const QColor& to, double share) {
  const figures::Rgb mix = figures::mixed(rgbOf(from), rgbOf(to), share);
  return {mix.red, mix.green, mix.blue};
}

double contrastOf(const QColor& one, const QColor& other) { return figures::contrast(rgbOf(one), rgbOf(other)); }

QColor termFill(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index) {
  const figures::Rgb color = figures::termColor(variable, terms, index);
  return {color.red, color.green, color.blue};
}

QColor termLine(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index) {
  return theme::readableLine(termFill(variable, terms, index));
}

QColor termText(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index) {
  return theme::readableText(termFill(variable, terms, index));
}

namespace {

void addPoint(TermOutline& outline, const fuzzy::MembershipFunction& function, double x) {
  outline.x << x;
  outline.membership << function(x);
}

}  // namespace

TermOutline outlineOf(const fuzzy::Term& term, double low, double high) {
  const fuzzy::MembershipFunction function = fuzzy::MembershipFunction::of(term);
  TermOutline outline;
  if (function.gaussian) {
    constexpr int kSteps = 96;
    for (int i = 0; i <= kSteps; ++i) addPoint(outline, function, low + (high - low) * i / kSteps);
    return outline;
  }
  const double first = std::max(low, function.a);
  const double last = std::min(high, function.d);
  if (first > last) return outline;
  if (function.a >= low) {
    outline.x << function.a;
    outline.membership << 0;
  }
  addPoint(outline, function, first);
  for (const double corner : {function.b, function.c}) {
    if (corner > first && corner < last) addPoint(outline, function, corner);
  }
  addPoint(outline, function, last);
  if (function.d <= high) {
    outline.x << function.d;
    outline.membership << 0;
  }
  return outline;
}

namespace {

/// The terms of `before` that are others in `now`, as lines.
std::vector<ChartLine> ghostsOf(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& now,
                                const std::vector<fuzzy::Term>& before, double low, double high, bool fast) {
  std::vector<ChartLine> out;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const fuzzy::Term* const same = fuzzy::findTerm(now, before[i].id);
    if (same != nullptr && same->shape == before[i].shape && same->points == before[i].points) continue;
    const TermOutline outline = outlineOf(before[i], low, high);
    out.push_back({outline.x, outline.membership, ghostPen(termLine(variable, before, i), fast)});
  }
  return out;
}

}  // namespace

bool addGhosts(QCustomPlot& plot, const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& now,
               const std::vector<fuzzy::Term>& before, double low, double high, bool fast) {
  const auto ghosts = ghostsOf(variable, now, before, low, high, fast);
  for (const ChartLine& ghost : ghosts) {
    QCPGraph* const graph = plot.addGraph();
    graph->setAdaptiveSampling(false);
    graph->setPen(ghost.pen);
    graph->setData(ghost.x, ghost.y, true);
  }
  return !ghosts.empty();
}

bool addGhosts(Chart& chart, const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& now,
               const std::vector<fuzzy::Term>& before, double low, double high) {
  const auto ghosts = ghostsOf(variable, now, before, low, high, false);
  chart.parts.insert(chart.parts.end(), ghosts.begin(), ghosts.end());
  return !ghosts.empty();
}

void fillTable(PlotTable& table, const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  table.columns = {"term", columnName(variable), "membership"};
  for (const fuzzy::Term& term : terms) {
    double low = variable.min;
    double high = variable.max;
    if (term.shape != fuzzy::Shape::kGaussian) {
      low = std::min(low, term.points.front());
      high = std::max(high, term.points.back());
    }
    const TermOutline outline = outlineOf(term, low, high);
    for (qsizetype i = 0; i < outline.x.size(); ++i) {
      table.rows.push_back({term.id, outline.x[i], outline.membership[i]});
    }
  }
}

namespace {

constexpr double kGap = 8;     // px between two names in a row
constexpr double kLeader = 4;  // px from the lowest row to the plot
constexpr double kBar = 4;     // px

}  // namespace

TermLabels::TermLabels(QCustomPlot& plot, int rows, Side side)
    : QCPLayerable(&plot, QStringLiteral("main")), rows_(rows), side_(side), font_(theme::smallFont()) {}

void TermLabels::setTerms(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  names_.clear();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    names_.push_back({labelOf(terms[i]), coreMiddle(variable, terms[i]), halfRange(variable, terms[i]),
                      termFill(variable, terms, i)});
  }
  // As they follow each other on the screen: the low end of a y axis is below.
  std::stable_sort(names_.begin(), names_.end(), [this](const Name& a, const Name& b) {
    return side_ == Side::kAbove ? a.center < b.center : a.center > b.center;
  });
}

const QCPAxis& TermLabels::axis() const {
  return *mParentPlot->axisRect()->axis(side_ == Side::kAbove ? QCPAxis::atBottom : QCPAxis::atLeft);
}

double TermLabels::barRoom() const { return bars_ ? kBar + 2 : 0; }

int TermLabels::height() const {
  return static_cast<int>(rows_ * QFontMetricsF(font_).height() + kLeader + barRoom()) + 1;
}

void TermLabels::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void TermLabels::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QFontMetricsF metrics(font_);
  const bool above = side_ == Side::kAbove;
  painter->save();
  // Turned by a right angle, what lies to the right of the plot lies above it.
  if (!above) painter->rotate(90);
  const double plot = (above ? area->top() : -area->right() - 1.0) - distance_;
  const double edge = plot - barRoom();
  const QCPRange shown = axis().range();
  std::vector<Label> labels;
  std::vector<const Name*> named;  // in sight, in the order of the labels
  for (const Name& name : names_) {
    const double low = std::max(name.half.low, shown.lower);
    const double high = std::min(name.half.high, shown.upper);
    if (!(low < high)) continue;
    named.push_back(&name);
    const double center = shown.contains(name.center) ? name.center : low / 2 + high / 2;
    labels.push_back({axis().coordToPixel(center), metrics.horizontalAdvance(name.text)});
    if (!bars_) continue;
    const double from = axis().coordToPixel(low);
    const double to = axis().coordToPixel(high);
    const QRectF bar(std::min(from, to) + 0.5, plot - kBar, std::abs(to - from) - 1, kBar);
    if (bar.width() > 0) painter->fillRect(bar, name.color);
  }
  const QRect viewport = mParentPlot->viewport();
  const auto places = placeLabels(labels, rows_, (above ? viewport.left() : viewport.top()) + 2,
                                  (above ? viewport.right() : viewport.bottom()) - 2, kGap);

  painter->setFont(font_);
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (!places[i]) continue;
    painter->setPen(QPen(theme::readableLine(named[i]->color), 1));
    painter->drawLine(QLineF(lineStart(labels[i], *places[i]), edge - kLeader - places[i]->row * metrics.height(),
                             labels[i].center, edge + 1.0));
  }
  // The names cover the lines: where one has to run through a name, the name stays readable.
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (!places[i]) continue;
    const double bottom = edge - kLeader - places[i]->row * metrics.height();
    painter->fillRect(QRectF(places[i]->left - 1, bottom - metrics.height(), labels[i].width + 2, metrics.height()),
                      theme::card());
    painter->setPen(theme::readableText(named[i]->color));
    painter->drawText(QPointF(places[i]->left, bottom - metrics.descent()), named[i]->text);
  }
  painter->restore();
}

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
