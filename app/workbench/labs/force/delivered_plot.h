// The delivered against the commanded force of every judgement, in the colors of the participants.
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "app/session/judged_forces.h"
#include "app/workbench/plot/plot_menu.h"

class QCustomPlot;
class QHBoxLayout;
class QLabel;

namespace tactus::workbench {

/// A judgement with what was in the hand.
struct DeliveredForce {
  std::size_t participant = 0;  ///< index in the names
  double commanded_n = 0;
  std::optional<double> least_n;  ///< the least force in the hand while it was judged
  std::optional<double> felt_n;   ///< commanded force plus the friction of the device
};

struct DeliveredForces {
  std::vector<std::string> participants;
  std::vector<DeliveredForce> forces;  ///< those for which it is known
  std::size_t unknown = 0;             ///< judgements without a measured force
};

DeliveredForces deliveredForces(const std::vector<session::JudgedForce>& all);

class DeliveredPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit DeliveredPlot(QWidget* parent = nullptr);

  void setForces(const DeliveredForces& forces);
  /// Adds `tool` beside the summary; it is there while there is something to draw.
  void addTool(QWidget* tool);

  std::vector<LegendEntry> legend() const override;
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  QCustomPlot* plot_;
  QLabel* summary_;
  QHBoxLayout* head_;
  QWidget* tool_ = nullptr;
  std::vector<LegendEntry> legend_;
};

}  // namespace tactus::workbench
