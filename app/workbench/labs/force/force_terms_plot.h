// The words of the force from one method, drawn over the shares of the answers that they come from (Fig. 3e).
#pragma once

#include <QWidget>
#include <vector>

#include "app/workbench/labs/force/force_data.h"
#include "app/workbench/plot/plot_source.h"

class QCustomPlot;

namespace tactus::workbench {

class ForceTermsPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit ForceTermsPlot(QWidget* parent = nullptr);

  /// `words` gives the colors; `votes` the shares; the axis ends at `end_n`.
  void setTerms(const fuzzy::Variable& words, const std::vector<fuzzy::Term>& terms,
                const std::vector<elicitation::VoteStep>& votes, double end_n);

  std::vector<LegendEntry> legend() const override;
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  QCustomPlot* plot_;
  fuzzy::Variable words_;
};

}  // namespace tactus::workbench
