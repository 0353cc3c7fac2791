#include "app/workbench/deliver/readiness_panel.h"

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/deliver/readiness_controller.h"
#include "app/workbench/deliver/readiness_row.h"

namespace tactus::workbench {

ReadinessPanel::ReadinessPanel(ReadinessController& readiness, QWidget* parent)
    : Card(parent), readiness_(readiness), summary_(new QLabel(this)) {
  summary_->setFont(theme::titleFont());
  summary_->setTextFormat(Qt::PlainText);
  auto* list = new QWidget;
  auto* lines = new QVBoxLayout(list);
  lines->setContentsMargins(0, 0, theme::kGrid, 0);
  lines->setSpacing(0);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i] = new ReadinessRow(list);
    lines->addWidget(rows_[i]);
    connect(rows_[i], &ReadinessRow::acted, this, [this, i] { emit asked(static_cast<ReadinessTopic>(i)); });
  }
  lines->addStretch(1);
  connect(rows_.front(), &ReadinessRow::holeAccepted, &readiness_, &ReadinessController::acceptHole);
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(list);
  for (QWidget* surface : {scroll->viewport(), list}) surface->setAutoFillBackground(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * theme::kGrid, 2 * theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(summary_);
  layout->addWidget(scroll, 1);

  auto* refresh = new Refresh(this, [this] { showLines(); });
  connect(&readiness_, &ReadinessController::changed, refresh, &Refresh::request);
  refresh->request();
}

void ReadinessPanel::showLines() {
  const auto& lines = readiness_.lines();
  summary_->setText(lines.empty() ? QString() : readinessSummary(lines));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i]->setVisible(i < lines.size());
    if (i < lines.size()) rows_[i]->setLine(lines[i]);
  }
  std::vector<DeliverFindings::Hole> open;
  const DeliverFindings& found = readiness_.findings();
  if (found.current) {
    std::copy_if(found.holes.begin(), found.holes.end(), std::back_inserter(open),
                 [](const DeliverFindings::Hole& hole) { return !hole.accepted; });
  }
  rows_.front()->showHoles(open);
}

}  // namespace tactus::workbench
