#include "app/workbench/plot/term_labels.h"

#include <QFontMetricsF>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/plot/label_layout.h"
#include "app/workbench/plot/term_colors.h"

namespace tactus::workbench {
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

}  // namespace tactus::workbench
