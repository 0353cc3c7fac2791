#include "app/workbench/labs/force/delivered_plot.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {
namespace {

constexpr double kDelivered = 6;  // px
constexpr double kGood = 0.9;     // share of the force that counts as delivered

QString summaryOf(const DeliveredForces& forces) {
  if (forces.forces.empty()) return DeliveredPlot::tr("No delivered force was measured.");
  const auto weak = std::count_if(forces.forces.begin(), forces.forces.end(), [](const DeliveredForce& one) {
    return one.least_n && *one.least_n < kGood * one.commanded_n;
  });
  QString out = DeliveredPlot::tr("%n judgement(s)", nullptr, static_cast<int>(forces.forces.size())) +
                QStringLiteral(" · ") +
                DeliveredPlot::tr("%n below 90 % of the force", nullptr, static_cast<int>(weak));
  if (forces.unknown > 0) {
    out += QStringLiteral(" · ") + DeliveredPlot::tr("%n not measured", nullptr, static_cast<int>(forces.unknown));
  }
  return out;
}

std::vector<std::size_t> colorNumbers(const std::vector<std::string>& participants) {
  std::vector<fuzzy::Expert> experts;
  for (const std::string& code : participants) {
    fuzzy::Expert expert;
    expert.id = code;
    experts.push_back(expert);
  }
  return figures::expertNumbers(experts);
}

}  // namespace

DeliveredForces deliveredForces(const std::vector<session::JudgedForce>& all) {
  DeliveredForces out;
  for (const session::JudgedForce& one : all) {
    if (one.record.commanded_n <= 0) continue;
    const auto& share = one.record.delivered_share;
    if (!share && !one.record.felt_n) {
      ++out.unknown;
      continue;
    }
    if (out.participants.empty() || out.participants.back() != one.participant)
      out.participants.push_back(one.participant);
    out.forces.push_back({out.participants.size() - 1, one.record.commanded_n,
                          share ? std::optional(*share * one.record.commanded_n) : std::nullopt, one.record.felt_n});
  }
  return out;
}

DeliveredPlot::DeliveredPlot(QWidget* parent)
    : QWidget(parent), plot_(makePlot(this)), summary_(new QLabel(this)), head_(new QHBoxLayout) {
  setMuted(*summary_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  head_->addWidget(summary_, 1);
  layout->addLayout(head_);
  layout->addWidget(plot_, 1);
  setAccessibleName(tr("Delivered against commanded force"));
}

void DeliveredPlot::setForces(const DeliveredForces& forces) {
  summary_->setText(summaryOf(forces));
  const bool some = !forces.forces.empty();
  plot_->setVisible(some);
  if (tool_ != nullptr) tool_->setVisible(some);
  summary_->setAlignment(some ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignCenter);
  legend_.clear();
  plot_->clearGraphs();
  double highest = 1.1;  // N, the end of the paper's table
  for (const DeliveredForce& one : forces.forces)
    highest = std::max({highest, one.commanded_n, one.felt_n.value_or(0)});
  fuzzy::Variable axis;
  axis.max = std::ceil(highest * 10) / 10;
  for (QCPAxis* side : {plot_->xAxis, plot_->yAxis}) styleAxis(*side, axis);
  plot_->xAxis->setLabel(tr("Commanded force (N)"));
  plot_->yAxis->setLabel(tr("Force in the hand (N)"));
  QCPGraph* const equal = plot_->addGraph();
  equal->setPen(QPen(theme::mutedInk(), 1, Qt::DashLine));
  equal->setData({0, axis.max}, {0, axis.max}, true);
  legend_.push_back({tr("Commanded"), equal->pen()});
  const auto numbers = colorNumbers(forces.participants);
  for (std::size_t who = 0; who < forces.participants.size(); ++who) {
    const QColor color = theme::expert(numbers[who]);
    QCPGraph* const least = plot_->addGraph();
    QCPGraph* const felt = plot_->addGraph();
    for (QCPGraph* dots : {least, felt}) {
      dots->setLineStyle(QCPGraph::lsNone);
      dots->setPen(QPen(color, 1.2));
      dots->setName(text(forces.participants[who]));
    }
    least->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, kDelivered));
    felt->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, kDelivered));
    for (const DeliveredForce& one : forces.forces) {
      if (one.participant != who) continue;
      if (one.least_n) least->addData(one.commanded_n, *one.least_n);
      if (one.felt_n) felt->addData(one.commanded_n, *one.felt_n);
    }
    legend_.push_back({harmless(text(forces.participants[who])), QPen(color, 2), Qt::NoBrush, true});
  }
  setToolTip(tr("Discs: the least force while it was judged. Circles: the force with the friction of the device."));
  redraw(*plot_);
}

void DeliveredPlot::addTool(QWidget* tool) {
  tool_ = tool;
  head_->addWidget(tool);
}

std::vector<LegendEntry> DeliveredPlot::legend() const { return legend_; }

void DeliveredPlot::paintPicture(QCPPainter& painter, const QSize& size) { paintPlot(*plot_, painter, size, {}); }

}  // namespace tactus::workbench
