#include "app/workbench/plots/term_labels.h"

#include <QFontMetricsF>
#include <algorithm>

#include "app/workbench/controllers/patient.h"
#include "app/workbench/display_text.h"
#include "app/workbench/plots/label_layout.h"
#include "app/workbench/theme.h"

namespace tactus::workbench {
namespace {

constexpr double kGap = 8;     // px between two names in a row
constexpr double kLeader = 4;  // px from the lowest row to the plot

}  // namespace

TermLabels::TermLabels(QCustomPlot& plot, int rows)
    : QCPLayerable(&plot, QStringLiteral("main")), rows_(rows), font_(theme::smallFont()) {}

void TermLabels::setTerms(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  names_.clear();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    names_.push_back({labelOf(terms[i]), coreMiddle(variable, terms[i]), i});
  }
  std::stable_sort(names_.begin(), names_.end(), [](const Name& a, const Name& b) { return a.center < b.center; });
}

int TermLabels::height() const { return static_cast<int>(rows_ * QFontMetricsF(font_).height() + kLeader) + 1; }

void TermLabels::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void TermLabels::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QFontMetricsF metrics(font_);
  std::vector<Label> labels;
  for (const Name& name : names_) {
    labels.push_back({area->axis(QCPAxis::atBottom)->coordToPixel(name.center), metrics.horizontalAdvance(name.text)});
  }
  const QRect viewport = mParentPlot->viewport();
  const auto places = placeLabels(labels, rows_, viewport.left() + 2, viewport.right() - 2, kGap);

  painter->setFont(font_);
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!places[i]) continue;
    painter->setPen(QPen(theme::term(names_[i].term, names_.size()), 1));
    painter->drawLine(QLineF(lineStart(labels[i], *places[i]),
                             area->top() - kLeader - places[i]->row * metrics.height(), labels[i].center,
                             area->top() + 1.0));
  }
  // The names cover the lines: where one has to run through a name, the name stays readable.
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!places[i]) continue;
    const double bottom = area->top() - kLeader - places[i]->row * metrics.height();
    painter->fillRect(QRectF(places[i]->left - 1, bottom - metrics.height(), labels[i].width + 2, metrics.height()),
                      theme::card());
    painter->setPen(theme::termText(names_[i].term, names_.size()));
    painter->drawText(QPointF(places[i]->left, bottom - metrics.descent()), names_[i].text);
  }
}

}  // namespace tactus::workbench
