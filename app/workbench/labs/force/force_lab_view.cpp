#include "app/workbench/labs/force/force_lab_view.h"

#include <QComboBox>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/force/check_view.h"
#include "app/workbench/labs/force/delivered_plot.h"
#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/labs/force/force_tables.h"
#include "app/workbench/labs/force/force_terms_plot.h"
#include "app/workbench/labs/force/force_terms_view.h"
#include "app/workbench/labs/force/judgement_view.h"
#include "app/workbench/labs/force/vote_words.h"
#include "app/workbench/labs/force/votes_view.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/plot/plot_menu.h"

namespace tactus::workbench {
namespace {

constexpr int kVotesWidth = 520;        // px: all columns of Table 2
constexpr int kNarrowVotesWidth = 384;  // px: all but the reasons
constexpr int kNarrowLab = 1400;        // px: below it the words need the room of the reasons

}  // namespace

ForceLabView::ForceLabView(ForceLab& lab, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      votes_(new VotesView),
      terms_(new ForceTermsView),
      judgements_(new JudgementView),
      checks_(new CheckView),
      delivered_(new DeliveredPlot),
      details_(new QTabWidget),
      series_(new QComboBox),
      top_(new QSplitter(Qt::Horizontal)) {
  setObjectName(QStringLiteral("force"));
  setWindowTitle(tr("Force"));
  judgements_->setObjectName(QStringLiteral("judgements"));
  checks_->setObjectName(QStringLiteral("checks"));
  delivered_->setObjectName(QStringLiteral("delivered"));
  series_->setAccessibleName(tr("Series that votes"));
  series_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  series_->setToolTip(tr("Choose the series that votes for the words of the force."));
  auto* table = new LabCard(tr("Votes for each force (Table 2)"), votes_);
  table->addTool(series_);
  auto* words = new LabCard(tr("Words of the force (Fig. 3e), four ways"), terms_);
  for (const auto from : kForceMethods) {
    terms_->addTool(from, new PlotMenu(
                              terms_->plot(from), [this, from] { return forceTermsTable(lab_, from); }, terms_));
  }
  top_->addWidget(table);
  top_->addWidget(words);
  top_->setStretchFactor(0, 0);
  top_->setStretchFactor(1, 1);
  new TabLook(*details_->tabBar());
  details_->setDocumentMode(true);
  details_->addTab(judgements_, tr("Judgements"));
  details_->addTab(checks_, tr("Checks"));
  details_->addTab(delivered_, tr("Delivered force"));
  details_->setCornerWidget(new StatisticHelp({Statistic::kWeightedKappa, Statistic::kInterval}));
  delivered_->addTool(new PlotMenu(
      *delivered_, [this] { return deliveredTable(lab_); }, delivered_));
  auto* below = new Card;
  auto* inside = new QVBoxLayout(below);
  inside->setContentsMargins(theme::kGrid, theme::kGrid / 2, theme::kGrid, theme::kGrid / 2);
  inside->addWidget(details_);
  auto* all = new QSplitter(Qt::Vertical);
  all->addWidget(top_);
  all->addWidget(below);
  all->setStretchFactor(0, 3);
  all->setStretchFactor(1, 2);
  for (QSplitter* splitter : {top_, all}) {
    splitter->setChildrenCollapsible(false);
    splitter->setHandleWidth(theme::kGrid);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(all);
  divide();

  connect(votes_, &VotesView::forceChosen, judgements_, &JudgementView::showForce);
  connect(terms_, &ForceTermsView::chosen, &lab_, &ForceLab::setMethod);
  connect(judgements_, &JudgementView::correctionAsked, &lab_, &ForceLab::correct);
  connect(judgements_, &JudgementView::judgementChosen, &lab_, &ForceLab::askInfluence);
  connect(&lab_, &ForceLab::influenceChanged, judgements_, [this] { judgements_->tell(lab_.influence()); });
  connect(series_, &QComboBox::activated, this,
          [this] { lab_.setSeries(series_->currentData().toString().toStdString()); });
  auto* refresh = new Refresh(this, [this] { follow(); });
  connect(&lab_, &ForceLab::changed, refresh, &Refresh::request);
}

void ForceLabView::showJudgement(const std::string& participant, const std::string& series, double force_n) {
  details_->setCurrentWidget(judgements_);
  judgements_->showJudgement(participant, series, force_n);
}

void ForceLabView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  lab_.setWanted(true);
}

void ForceLabView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  lab_.setWanted(false);
}

// The user's own division stays until the lab becomes wide or narrow.
void ForceLabView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool narrow = width() < kNarrowLab;
  if (std::exchange(narrow_, narrow) != narrow) divide();
}

void ForceLabView::divide() {
  const int votes = narrow_ ? kNarrowVotesWidth : kVotesWidth;
  top_->setSizes({votes, std::max(1, width() - votes)});
}

void ForceLabView::follow() {
  votes_->setVotes(lab_.votes());
  terms_->setVotes(lab_.votes());
  terms_->setChosen(lab_.settings().force_terms);
  judgements_->setJudgements(lab_.votes().words, lab_.judgements());
  checks_->setChecks(lab_.checks());
  delivered_->setForces(deliveredForces(lab_.judgements()));
  followSeries();
}

void ForceLabView::followSeries() {
  const QSignalBlocker quiet(series_);
  series_->clear();
  for (const std::string& name : lab_.series()) series_->addItem(seriesText(name), text(name));
  series_->setCurrentIndex(std::max(0, series_->findData(text(lab_.settings().series))));
  series_->setVisible(series_->count() > 1);
}

}  // namespace tactus::workbench
