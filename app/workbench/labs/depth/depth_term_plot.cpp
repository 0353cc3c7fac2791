#include "app/workbench/labs/depth/depth_term_plot.h"

#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_colors.h"
#include "app/workbench/plot/term_labels.h"
#include "app/workbench/plot/term_outline.h"

namespace tactus::workbench {
namespace {

constexpr int kLabelRows = 2;

}  // namespace

DepthTermPlot::DepthTermPlot(QWidget* parent) : QWidget(parent), plot_(makePlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumHeight(150);
  setAccessibleName(tr("Terms of the depth"));
  labels_ = new TermLabels(*plot_, kLabelRows);
  plot_->axisRect()->setAutoMargins(QCP::msBottom | QCP::msLeft);
  plot_->axisRect()->setMargins(QMargins(0, labels_->height(), 2 * theme::kGrid, 0));
}

void DepthTermPlot::show(const fuzzy::Variable& depth) {
  plot_->clearGraphs();
  styleAxis(*plot_->xAxis, depth);
  styleAxis(*plot_->yAxis, depth);
  plot_->xAxis->setLabel(axisText(depth));
  plot_->xAxis->grid()->setVisible(false);
  plot_->yAxis->setRange(0, 1.06);
  auto ticker = QSharedPointer<QCPAxisTickerFixed>::create();
  ticker->setTickStep(0.5);
  plot_->yAxis->setTicker(ticker);
  for (std::size_t i = 0; i < depth.terms.size(); ++i) {
    const TermOutline outline = outlineOf(depth.terms[i], depth.min, depth.max);
    addShape(*plot_, termLine(depth, depth.terms, i), 1.5, 0.2F).setData(outline.x, outline.membership, true);
  }
  labels_->setTerms(depth, depth.terms);
  redraw(*plot_);
}

void DepthTermPlot::paintPicture(QCPPainter& painter, const QSize& size) { paintPlot(*plot_, painter, size, {}); }

}  // namespace tactus::workbench
