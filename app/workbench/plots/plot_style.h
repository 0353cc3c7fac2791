// What all plots have in common: colors, axes, fonts. Includes QCustomPlot, so only files of plots/ include it.
#pragma once

#include <initializer_list>
#include <qcustomplot.h>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// A plot without interactions, decorations or legend, in the colors of the theme.
QCustomPlot* makePlot(QWidget* parent);

/// Lines and fonts of an axis over the universe of `variable`.
void styleAxis(QCPAxis& axis, const fuzzy::Variable& variable);

/// Draws `plot` over `size` px at the origin of `painter` without `hidden`; on the screen it stays as it was.
void paintPlot(QCustomPlot& plot, QCPPainter& painter, const QSize& size, std::initializer_list<QCPLayerable*> hidden);

/// Ticks at round numbers and at both ends of the universe.
class UniverseTicker : public QCPAxisTicker {
 protected:
  QVector<double> createTickVector(double step, const QCPRange& range) override;
};

}  // namespace tactus::workbench
