// The words of the force from one method, drawn over the shares of the answers that they come from (Fig. 3e).
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "app/workbench/labs/force/force_data.h"
#include "app/workbench/plot/plot_menu.h"

class QCustomPlot;

namespace tactus::workbench {

class VertexPick;

class ForceTermsPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit ForceTermsPlot(QWidget* parent = nullptr);

  /// `words` gives the colors; `votes` the shares; the axis ends at `end_n`.
  void setTerms(const fuzzy::Variable& words, const std::vector<fuzzy::Term>& terms,
                const std::vector<elicitation::VoteStep>& votes, double end_n);

  VertexPick& corners() { return *corners_; }
  std::vector<LegendEntry> legend() const override;
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 signals:
  /// The user clicked a corner of a word.
  void vertexAsked(const std::string& term, std::size_t point);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// As many ticks, and as much of the text, as there is room for.
  void fitAxis();

  QCustomPlot* plot_;
  VertexPick* corners_;
  fuzzy::Variable words_;
  QString axis_text_;
  QString axis_unit_;
};

}  // namespace tactus::workbench
