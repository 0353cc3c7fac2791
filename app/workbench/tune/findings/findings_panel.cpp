#include "app/workbench/tune/findings/findings_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/finding_words.h"
#include "app/workbench/tune/findings/finding_delegate.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/findings/fix_card.h"

namespace tactus::workbench {
namespace {

constexpr int kAll = -1;

}  // namespace

FindingsPanel::FindingsPanel(FindingsController& findings, QWidget* parent)
    : Card(parent),
      findings_(findings),
      model_(findings),
      delegate_(new FindingDelegate(model_, this)),
      kind_(new QComboBox(this)),
      who_(new QComboBox(this)),
      order_(new QComboBox(this)),
      state_(new ElidedLabel(this)),
      list_(new QListView(this)),
      empty_(new QLabel(this)),
      body_(new QStackedWidget(this)),
      range_(new ElidedLabel(this)) {
  kind_->setAccessibleName(tr("Which findings are listed"));
  who_->setAccessibleName(tr("Whose findings are listed"));
  order_->setAccessibleName(tr("Order of the findings"));
  order_->addItem(tr("By newtons"), static_cast<int>(FindingOrder::kNewtons));
  order_->addItem(tr("By expert"), static_cast<int>(FindingOrder::kExpert));
  order_->addItem(tr("By place"), static_cast<int>(FindingOrder::kPlace));
  for (QComboBox* choice : {kind_, who_, order_}) {
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(6);
    choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    choice->setMaximumWidth(220);
  }
  setMuted(*state_);
  setMuted(*range_);
  list_->setModel(&model_);
  list_->setItemDelegate(delegate_);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setMouseTracking(true);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setResizeMode(QListView::Adjust);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list_->setObjectName(QStringLiteral("findings_list"));
  list_->setAccessibleName(tr("Findings"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  body_->addWidget(list_);
  body_->addWidget(empty_);

  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid);
  head->addWidget(kind_, 30);
  head->addWidget(who_, 20);
  head->addWidget(order_, 20);
  head->addStretch(1);  // with much room the choices stay at the left
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addLayout(head);
  layout->addWidget(state_);
  layout->addWidget(body_, 1);
  layout->addWidget(new FixCard(findings_, this));
  layout->addWidget(range_);
  new RowStop({kind_, who_, order_}, this);

  connect(kind_, &QComboBox::activated, this, [this] {
    const int kind = kind_->currentData().toInt();
    model_.setKind(kind == kAll ? std::nullopt : std::optional(static_cast<elicitation::RuleFinding::Kind>(kind)));
    showChosen();
    showState();
  });
  connect(who_, &QComboBox::activated, this, [this] {
    model_.setWho(who_->currentData().toString());
    showChosen();
    showState();
  });
  connect(order_, &QComboBox::activated, this, [this] {
    model_.setOrder(static_cast<FindingOrder>(order_->currentData().toInt()));
    showChosen();
  });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& index) {
    if (!index.isValid() || !model_.isCurrent() || model_.isHeading(index.row())) return;
    findings_.choose(model_.indexAt(index.row()));
  });
  connect(list_, &QListView::activated, this, [this](const QModelIndex& index) { fold(index.row()); });
  connect(list_, &QListView::clicked, this, [this](const QModelIndex& index) {
    if (model_.isHeading(index.row())) {
      fold(index.row());
      return;
    }
    // A second click on the same row goes back to its place.
    if (model_.isCurrent() && findings_.chosen() == model_.indexAt(index.row())) findings_.goTo(false);
  });
  connect(&findings_, &FindingsController::changed, this, &FindingsPanel::adopt);
  // The fixes below take room from the list once they are laid out.
  connect(
      &findings_, &FindingsController::fixesChanged, this, [this] { list_->scrollTo(list_->currentIndex()); },
      Qt::QueuedConnection);
  showState();
}

void FindingsPanel::showEvent(QShowEvent* event) {
  Card::showEvent(event);
  // A panel that is on its way behind a tab is shown for a moment.
  QTimer::singleShot(0, this, [this] {
    if (!isVisible()) return;
    findings_.setWatched(true);
    adopt();
  });
}

void FindingsPanel::hideEvent(QHideEvent* event) {
  Card::hideEvent(event);
  findings_.setWatched(false);
}

void FindingsPanel::adopt() {
  if (!isVisible()) return;
  delegate_->setOld(!findings_.isCurrent());
  // A drag only makes the findings old.
  if (!model_.isCurrent()) {
    if (const auto* const model = findings_.lintedModel()) delegate_->setForceUnit(model->output.unit);
    fillFilters();
    const QSignalBlocker quiet(list_->selectionModel());
    model_.adopt();
  }
  showChosen();
  showState();
}

void FindingsPanel::fillFilters() {
  std::map<int, std::pair<QString, int>> kinds;
  int count = 0;
  for (const ShownFinding& shown : findings_.findings()) {
    auto& [name, number] = kinds[static_cast<int>(shown.finding.kind)];
    name = kindText(shown.finding.kind);
    ++number;
    ++count;
  }
  const QVariant kind = kind_->currentData();
  kind_->clear();
  kind_->addItem(tr("All findings (%1)").arg(count), kAll);
  for (const auto& [id, named] : kinds) kind_->addItem(tr("%1 (%2)").arg(named.first).arg(named.second), id);
  kind_->setCurrentIndex(std::max(0, kind_->findData(kind)));
  const int now = kind_->currentData().toInt();
  model_.setKind(now == kAll ? std::nullopt : std::optional(static_cast<elicitation::RuleFinding::Kind>(now)));

  const QVariant who = who_->currentData();
  who_->clear();
  who_->addItem(tr("All experts"), QString());
  if (const auto* const model = findings_.lintedModel()) {
    who_->addItem(tr("Mean"), tr("Mean"));
    for (const fuzzy::Expert& expert : model->experts) who_->addItem(labelOf(expert), labelOf(expert));
  }
  who_->setCurrentIndex(std::max(0, who_->findData(who)));
  model_.setWho(who_->currentData().toString());
}

// The heading keeps its place, and the keys stay with it.
void FindingsPanel::fold(int row) {
  if (row >= model_.rowCount() || !model_.isHeading(row)) return;
  const QSignalBlocker quiet(list_->selectionModel());
  model_.fold(row);
  list_->setCurrentIndex(model_.index(row));
  list_->viewport()->update();
}

void FindingsPanel::showChosen() {
  const auto chosen = findings_.chosen();
  const int row = chosen ? model_.rowOf(*chosen) : -1;
  const QSignalBlocker quiet(list_->selectionModel());
  list_->setCurrentIndex(row < 0 ? QModelIndex() : model_.index(row));
  list_->viewport()->update();
}

void FindingsPanel::showState() {
  state_->setFullText(stateText());
  state_->setVisible(!stateText().isEmpty());
  range_->setFullText(rangeText());
  range_->setVisible(!rangeText().isEmpty());
  const bool any = model_.rowCount() > 0;
  if (!any) empty_->setText(emptyText());
  body_->setCurrentWidget(any ? static_cast<QWidget*>(list_) : empty_);
}

QString FindingsPanel::stateText() const {
  if (!findings_.isCurrent()) return tr("Looking…");
  const auto* const lint = findings_.lint();
  if (!lint->model.coverage_complete) return tr("The search for holes was cut off: the model is too finely divided");
  if (!lint->newtons_complete) return tr("The model is very large, so only some forces were computed");
  return {};
}

QString FindingsPanel::emptyText() const {
  if (!findings_.isCurrent()) return tr("Looking for holes, conflicts and jumps…");
  if (!findings_.findings().empty()) return tr("None of these.");
  return tr(
      "Nothing found: every place has a force, no two rules contradict each other, and no step of the force is "
      "against the declared directions.");
}

QString FindingsPanel::rangeText() const {
  const auto* const lint = findings_.lint();
  const auto* const model = findings_.lintedModel();
  if (lint == nullptr || lint->model.reachable.fired == 0) return {};
  const auto& range = lint->model.reachable;
  const std::string& unit = model->output.unit;
  return tr("Reachable force: %1 to %2 of the universe from %3 to %4")
      .arg(forceText(range.min_n, unit), forceText(range.max_n, unit), quantityText(model->output.min, unit),
           quantityText(model->output.max, unit));
}

}  // namespace tactus::workbench
