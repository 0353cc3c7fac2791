#include "app/workbench/labs/depth/length_plot.h"

#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_colors.h"
#include "elicitation/depth/depth_measurement.h"

namespace tactus::workbench {
namespace {

constexpr double kMmPerCm = 10;
constexpr double kRegionsBottom = 3.7;  // above the bars, which are at 1, 2 and 3
constexpr double kRegionsTop = 4.2;
constexpr double kBarHalf = 0.26;
constexpr double kLeastShownMm = 40;  // a shorter region has no room for its name

}  // namespace

QString centimeters(double length_mm) { return quantityText(length_mm / kMmPerCm, "cm", 1); }

QString formulaName(elicitation::LengthFormula formula) {
  switch (formula) {
    case elicitation::LengthFormula::kNoseEarXiphoid:
      return LengthPlot::tr("Nose – ear – xiphoid");
    case elicitation::LengthFormula::kHanson:
      return LengthPlot::tr("Hanson");
    case elicitation::LengthFormula::kCorrected:
      return LengthPlot::tr("Corrected");
  }
  return {};
}

LengthPlot::LengthPlot(QWidget* parent) : QWidget(parent), plot_(makePlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumSize(280, 170);
  setAccessibleName(tr("Length of the tube by each formula"));
  plot_->yAxis->setVisible(false);
  plot_->yAxis->setRange(0.5, kRegionsTop + 0.1);
  plot_->axisRect()->setAutoMargins(QCP::msBottom);
  plot_->axisRect()->setMargins(QMargins(theme::kGrid, 0, theme::kGrid, 0));
}

void LengthPlot::addBar(double from_mm, double to_mm, double bottom, double top, const QColor& fill) {
  auto* const bar = new QCPItemRect(plot_);
  bar->topLeft->setCoords(from_mm / kMmPerCm, top);
  bar->bottomRight->setCoords(to_mm / kMmPerCm, bottom);
  bar->setPen(Qt::NoPen);
  bar->setBrush(fill);
}

void LengthPlot::addText(double at_mm, double height, const QString& words, const QColor& ink, Qt::Alignment side) {
  auto* const label = new QCPItemText(plot_);
  label->position->setCoords(at_mm / kMmPerCm, height);
  label->setPositionAlignment(side | Qt::AlignVCenter);
  label->setFont(theme::smallFont());
  label->setColor(ink);
  label->setPadding(QMargins(4, 0, 4, 0));
  label->setText(words);
}

void LengthPlot::show(const fuzzy::Variable& depth, const std::vector<elicitation::InsertionLength>& lengths,
                      const elicitation::DepthRange& target) {
  plot_->clearItems();
  double end_mm = std::max(depth.max, target.to_mm);
  for (const auto& one : lengths) end_mm = std::max(end_mm, one.length_mm);
  fuzzy::Variable axis = depth;
  axis.unit = "cm";
  axis.min = 0;
  axis.max = std::ceil(end_mm / 50) * 50 / kMmPerCm;
  styleAxis(*plot_->xAxis, axis);
  plot_->xAxis->setLabel(tr("From the nostril (cm)"));
  plot_->xAxis->grid()->setVisible(false);
  QColor band = theme::accent();
  band.setAlphaF(0.16F);
  addBar(target.from_mm, target.to_mm, 0.5, kRegionsBottom, theme::onCard(band));
  const auto boundaries = elicitation::boundariesOf(depth.terms);
  double from_mm = depth.min;
  for (std::size_t k = 0; k < depth.terms.size(); ++k) {
    const double to_mm = k < boundaries.size() ? boundaries[k].depth_mm : depth.max;
    const QColor fill = termFill(depth, depth.terms, k);
    addBar(from_mm, to_mm, kRegionsBottom, kRegionsTop, fill);
    if (to_mm - from_mm >= 2 * kLeastShownMm) {
      addText((from_mm + to_mm) / 2, (kRegionsBottom + kRegionsTop) / 2, labelOf(depth.terms[k]), theme::inkOn(fill),
              Qt::AlignHCenter);
    }
    from_mm = to_mm;
  }
  double row = 3;
  for (const auto& one : lengths) {
    const QColor line = theme::readableLine(one.in_target ? theme::accent() : theme::mutedInk());
    addBar(0, one.length_mm, row - kBarHalf, row + kBarHalf, line);
    addText(0, row, formulaName(one.formula), theme::inkOn(line), Qt::AlignLeft);
    addText(one.length_mm, row, centimeters(one.length_mm), theme::inkOn(line), Qt::AlignRight);
    --row;
  }
  redraw(*plot_);
}

void LengthPlot::paintPicture(QCPPainter& painter, const QSize& size) { paintPlot(*plot_, painter, size, {}); }

}  // namespace tactus::workbench
