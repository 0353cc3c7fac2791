#include "app/workbench/plots/plot_style.h"

#include "app/workbench/theme.h"

namespace tactus::workbench {

QCustomPlot* makePlot(QWidget* parent) {
  auto* plot = new QCustomPlot(parent);
  plot->setLocale(QLocale::c());
  plot->setBackground(QBrush(theme::card()));
  plot->setAntialiasedElements(QCP::aeAll);
  plot->setNoAntialiasingOnDrag(false);
  plot->legend->setVisible(false);
  plot->setFocusPolicy(Qt::NoFocus);
  // The first replot sets up the buffers, so that from here on a layer can be drawn alone.
  plot->replot();
  return plot;
}

void styleAxis(QCPAxis& axis, const fuzzy::Variable& variable) {
  axis.setRange(variable.min, variable.max);
  axis.setTicker(QSharedPointer<UniverseTicker>::create());
  axis.setNumberFormat(QStringLiteral("g"));
  axis.setNumberPrecision(5);
  axis.setSubTicks(false);
  axis.setBasePen(QPen(theme::border(), 1));
  axis.setTickPen(QPen(theme::border(), 1));
  axis.setTickLength(0, 4);
  axis.setTickLabelPadding(4);
  axis.setTickLabelColor(theme::mutedInk());
  axis.setLabelColor(theme::mutedInk());
  axis.setTickLabelFont(theme::smallFont());
  axis.setLabelFont(theme::smallFont());
  axis.grid()->setPen(QPen(theme::grid(), 1));
  axis.grid()->setZeroLinePen(QPen(theme::grid(), 1));
}

QVector<double> UniverseTicker::createTickVector(double step, const QCPRange& range) {
  QVector<double> ticks;
  // A round number too near to an end would print over it.
  for (const double tick : QCPAxisTicker::createTickVector(step, range)) {
    if (tick - range.lower > 0.6 * step && range.upper - tick > 0.6 * step) ticks << tick;
  }
  ticks.prepend(range.lower);
  ticks.append(range.upper);
  return ticks;
}

}  // namespace tactus::workbench
