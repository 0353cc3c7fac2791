#include "app/workbench/labs/speed/cluster_page.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/labs/speed/cluster_plot.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/labs/speed/speed_term_plot.h"
#include "app/workbench/plot/plot_menu.h"

namespace tactus::workbench {

ClusterPage::ClusterPage(SpeedLab& lab, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      terms_(nullptr),
      key_(new ElidedLabel(this)),
      said_(new QLabel(this)),
      waiting_(new QLabel(this)) {
  auto* clusters = new Card(this);
  setMuted(*key_);
  key_->setFullText(
      tr("gray: samples · lines: membership in each cluster · dotted: its center, 95 % interval at the foot"));
  auto* head = new QHBoxLayout;
  auto* title = new QLabel(tr("Clusters of each participant"), clusters);
  title->setFont(theme::headingFont());
  head->addWidget(title);
  head->addSpacing(theme::kGrid);
  head->addWidget(key_, 1);
  head->addWidget(new StatisticHelp({Statistic::kInterval}, clusters));
  head->addWidget(new PlotMenu(
      *this, [this] { return clusterTable(); }, clusters));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * theme::kGrid);
  grid->setVerticalSpacing(theme::kGrid);
  for (std::size_t i = 0; i < SpeedLab::kPerPage; ++i) {
    plots_.push_back(new ClusterPlot(clusters));
    grid->addWidget(plots_.back(), static_cast<int>(i / 2), static_cast<int>(i % 2));
    plots_.back()->hide();
  }
  setMuted(*waiting_);
  waiting_->setText(tr("The strokes of the study are being read and clustered…"));
  waiting_->setAlignment(Qt::AlignCenter);
  auto* inside = new QVBoxLayout(clusters);
  inside->setContentsMargins(theme::kGrid + 4, theme::kGrid / 2, theme::kGrid, theme::kGrid / 2);
  inside->setSpacing(theme::kGrid / 2);
  inside->addLayout(head);
  inside->addLayout(grid, 1);
  inside->addWidget(waiting_, 1);  // not over the cells of the grid, which would have no space between them then
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(clusters, 7);
  layout->addWidget(makeTerms(), 4);
  auto* refresh = new Refresh(this, [this] { follow(); });
  connect(&lab_, &SpeedLab::resultChanged, refresh, &Refresh::request);
  connect(&lab_, &SpeedLab::pageChanged, refresh, &Refresh::request);
  refresh->request();
}

QWidget* ClusterPage::makeTerms() {
  auto* card = new Card(this);
  terms_ = new SpeedTermPlot(card);
  setMuted(*said_);
  auto* title = new ElidedLabel(card);
  title->setFullText(tr("Terms: each participant’s and the average"), tr("Terms"));
  title->setFont(theme::headingFont());
  auto* head = new QHBoxLayout;
  head->addWidget(title);
  head->addSpacing(theme::kGrid);
  head->addWidget(said_, 1);
  head->addWidget(new PlotMenu(
      *terms_, [this] { return termTable(); }, card));
  auto* inside = new QVBoxLayout(card);
  inside->setContentsMargins(theme::kGrid + 4, theme::kGrid / 2, theme::kGrid, theme::kGrid / 2);
  inside->setSpacing(2);
  inside->addLayout(head);
  inside->addWidget(terms_, 1);
  return card;
}

void ClusterPage::follow() {
  const auto& result = lab_.result();
  const auto [first, last] = lab_.shown();
  for (std::size_t i = 0; i < plots_.size(); ++i) plots_[i]->setVisible(first + i < last);
  waiting_->setVisible(!result);
  if (!result) return;
  const std::vector<std::size_t> numbers = subjectNumbers(*result);
  for (std::size_t i = first; i < last; ++i) {
    const bool known = result->intervals && i < result->intervals->participants.size();
    plots_[i - first]->show(*result->subjects[i], result->speed, numbers[i],
                            known ? result->intervals->participants[i].centres : std::vector<elicitation::Interval>());
  }
  terms_->show(*result);
  if (!result->failure.empty()) {
    said_->setText(tr("Nothing is averaged: %1").arg(text(result->failure)));
  } else if (result->averaged.empty()) {
    said_->setText(tr("No terms: their number is not that of the clusters."));
  } else {
    QStringList corners;
    for (const elicitation::Ramp& ramp : result->averaged) {
      corners << numberText(ramp.p, 1) + QStringLiteral(" – ") + numberText(ramp.q, 1);
    }
    said_->setText(tr("ramps %1 mm/s").arg(corners.join(QStringLiteral(" · "))));
  }
}

QString ClusterPage::settingText() const {
  const elicitation::SpeedTermSettings& settings = lab_.settings();
  return tr("c %1 · m %2 · α %3 · trimming %4")
      .arg(lab_.clusters())
      .arg(numberText(settings.fcm.m), numberText(settings.alpha), numberText(settings.trim));
}

PlotTable ClusterPage::clusterTable() const {
  PlotTable table;
  table.file = QStringLiteral("speed-clusters");
  table.caption << tr("Clusters of insertion speeds (paper, Fig. 7)") << settingText();
  table.columns = {"participant", "cluster", "centre_mm_s", "low_mm_s", "high_mm_s"};
  const auto& result = lab_.result();
  for (std::size_t i = 0; result && i < result->subjects.size(); ++i) {
    const elicitation::ParticipantSpeeds& one = result->subjects[i]->speeds;
    if (one.simulated && i == 0) table.caption << tr("The data are simulated.");
    for (std::size_t k = 0; k < one.centres.size(); ++k) {
      std::vector<PlotTable::Cell> row = {one.participant, static_cast<double>(k + 1), one.centres[k]};
      if (result->intervals) {
        const elicitation::Interval& interval = result->intervals->participants[i].centres[k];
        row.emplace_back(interval.low);
        row.emplace_back(interval.high);
      } else {
        row.resize(table.columns.size());
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

PlotTable ClusterPage::termTable() const {
  PlotTable table;
  table.file = QStringLiteral("speed-terms");
  table.caption << tr("Speed terms of each participant and their average (paper, Fig. 8)") << settingText();
  table.columns = {"participant", "ramp", "from_mm_s", "to_mm_s"};
  const auto& result = lab_.result();
  if (!result) return table;
  const auto add = [&table](const std::string& who, const std::vector<elicitation::Ramp>& ramps) {
    for (std::size_t k = 0; k < ramps.size(); ++k) {
      table.rows.push_back({who, static_cast<double>(k + 1), ramps[k].p, ramps[k].q});
    }
  };
  for (const auto& subject : result->subjects) add(subject->speeds.participant, subject->speeds.ramps);
  add("average", result->averaged);
  if (!result->subjects.empty() && result->subjects.front()->speeds.simulated) {
    table.caption << tr("The data are simulated.");
  }
  return table;
}

void ClusterPage::paintPicture(QCPPainter& painter, const QSize& size) {
  painter.fillRect(QRect(QPoint(0, 0), size), theme::card());
  const QSize cell(size.width() / 2, size.height() / 2);
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    if (plots_[i]->isHidden()) continue;
    const QPoint place(i % 2 == 0 ? 0 : cell.width(), i < 2 ? 0 : cell.height());
    painter.translate(place);
    plots_[i]->paint(painter, cell);
    painter.translate(-place);
  }
}

}  // namespace tactus::workbench
