#include "app/workbench/labs/force/force_terms_plot.h"

#include <QFontMetrics>
#include <QVBoxLayout>
#include <numeric>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_colors.h"
#include "app/workbench/plot/term_outline.h"
#include "app/workbench/plot/plot_marks.h"

namespace tactus::workbench {
namespace {

constexpr double kDot = 7;    // px
constexpr int kNarrow = 200;  // px: below it ticks would touch
constexpr int kFewTicks = 2;
constexpr int kUsualTicks = 5;
constexpr float kFill = 0.10F;
constexpr double kAsideShare = 0.014;  // of the axis: equal shares of one force would hide each other

}  // namespace

ForceTermsPlot::ForceTermsPlot(QWidget* parent)
    : QWidget(parent),
      plot_(makePlot(this)),
      corners_(new VertexPick(*plot_, tr("Click: where does this corner come from?"))) {
  connect(corners_, &VertexPick::picked, this, &ForceTermsPlot::vertexAsked);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumSize(120, 96);
  plot_->axisRect()->setMinimumMargins(QMargins(0, theme::kGrid / 2, theme::kGrid + 4, 0));
  setAccessibleName(tr("Words of the force"));
}

void ForceTermsPlot::setTerms(const fuzzy::Variable& words, const std::vector<fuzzy::Term>& terms,
                              const std::vector<elicitation::VoteStep>& votes, double end_n) {
  words_ = words;
  plot_->clearGraphs();
  fuzzy::Variable axis = words;
  axis.max = end_n;
  styleAxis(*plot_->xAxis, axis);
  axis_text_ = axisText(axis);
  axis_unit_ = QString::fromStdString(axis.unit);
  fitAxis();
  plot_->xAxis->grid()->setVisible(false);
  fuzzy::Variable membership;
  membership.max = 1;
  styleAxis(*plot_->yAxis, membership);
  auto ticks = QSharedPointer<QCPAxisTickerFixed>::create();
  ticks->setTickStep(0.5);
  plot_->yAxis->setTicker(ticks);
  plot_->yAxis->setRange(0, 1.06);  // the dots of full shares stay whole
  std::vector<VertexPick::Vertex> corners;
  const double middle = 0.5 * static_cast<double>(words.terms.size() - 1);
  for (std::size_t k = 0; k < words.terms.size(); ++k) {
    const QColor line = termLine(words, words.terms, k);
    if (const fuzzy::Term* const term = fuzzy::findTerm(terms, words.terms[k].id)) {
      const TermOutline outline = outlineOf(*term, words.min, end_n);
      addShape(*plot_, line, 2, kFill).setData(outline.x, outline.membership, true);
      for (std::size_t p = 0; p < term->points.size(); ++p) {
        corners.push_back({term->id, p, term->points[p], p == 0 || p + 1 == term->points.size() ? 0.0 : 1.0});
      }
    }
    QVector<double> at;
    QVector<double> share;
    for (const elicitation::VoteStep& step : votes) {
      const int cast = std::accumulate(step.votes.begin(), step.votes.end(), 0);
      if (cast == 0 || step.votes[k] == 0) continue;
      at << step.force_n + kAsideShare * end_n * (static_cast<double>(k) - middle);
      share << static_cast<double>(step.votes[k]) / cast;
    }
    QCPGraph* const dots = plot_->addGraph();
    dots->setLineStyle(QCPGraph::lsNone);
    dots->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(theme::card(), 1), line, kDot));
    dots->setData(at, share, true);
  }
  // Ends of the universe come from no answer.
  std::erase_if(corners, [&](const auto& one) { return one.x <= words.min || one.x >= end_n; });
  corners_->setVertices(std::move(corners));
  redraw(*plot_);
}

void ForceTermsPlot::fitAxis() {
  plot_->xAxis->ticker()->setTickCount(width() < kNarrow ? kFewTicks : kUsualTicks);
  // The text stands in the middle of the axis, which begins beside the numbers of the other one.
  const QFontMetrics metrics(plot_->xAxis->labelFont());
  const int beside = metrics.horizontalAdvance(QStringLiteral("0.5")) + 4 * theme::kGrid;
  plot_->xAxis->setLabel(metrics.horizontalAdvance(axis_text_) + beside <= width() ? axis_text_ : axis_unit_);
}

void ForceTermsPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitAxis();
}

std::vector<LegendEntry> ForceTermsPlot::legend() const {
  std::vector<LegendEntry> out;
  for (std::size_t k = 0; k < words_.terms.size(); ++k) {
    out.push_back({labelOf(words_.terms[k]), QPen(termLine(words_, words_.terms, k), 2)});
  }
  return out;
}

void ForceTermsPlot::paintPicture(QCPPainter& painter, const QSize& size) { paintPlot(*plot_, painter, size, {}); }

}  // namespace tactus::workbench
