#include "app/workbench/tune/rules/rule_grid_pane.h"

#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/tune/rules/rule_cell_bar.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_grids.h"

namespace tactus::workbench {

RuleGridPane::RuleGridPane(RuleController& rules, QWidget* parent)
    : QWidget(parent),
      rules_(rules),
      area_(new QScrollArea(this)),
      grids_(new RuleGrids(rules)),
      cell_(new RuleCellBar(rules, this)),
      hint_(new ElidedLabel(this)),
      refresh_(new Refresh(this, [this] { showRules(); })) {
  area_->setFrameShape(QFrame::NoFrame);
  area_->setWidgetResizable(true);
  area_->setWidget(grids_);
  setFocusProxy(grids_);
  area_->setFocusPolicy(Qt::NoFocus);
  area_->viewport()->setAutoFillBackground(false);
  grids_->setAutoFillBackground(false);
  hint_->setFont(theme::smallFont());
  hint_->setForegroundRole(QPalette::PlaceholderText);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addWidget(area_, 1);
  layout->addWidget(cell_);
  layout->addWidget(hint_);

  connect(&rules_, &RuleController::rulesChanged, refresh_, &Refresh::request);
  connect(&rules_, &RuleController::hereChanged, refresh_, &Refresh::request);
  connect(&rules_, &RuleController::selectionChanged, this, &RuleGridPane::showSelection);
  connect(cell_, &RuleCellBar::done, grids_, [this] { grids_->setFocus(); });
  setFocusProxy(grids_);
  refresh_->request();
}

void RuleGridPane::showRules() {
  if (!rules_.isOpen()) return;
  // The keys need a cell to begin with.
  rules_.beginAnywhere();
  grids_->showRules();
  cell_->showCell();
  const std::size_t words = std::min<std::size_t>(9, rules_.words().size());
  hint_->setFullText(
      tr("1–%1 answer and go on · Space skips · Del empties · arrows move · bar: how strongly it acts here")
          .arg(words));
}

void RuleGridPane::showSelection() {
  if (!isVisible() || !rules_.isOpen()) return;
  cell_->showCell();
  if (const auto cell = rules_.selected()) {
    const QRect place = grids_->cellRect(*cell);
    area_->ensureVisible(place.center().x(), place.center().y(), place.width(), place.height());
  }
}

}  // namespace tactus::workbench
