#include "app/workbench/tune/findings/findings_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <map>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/finding_words.h"
#include "app/workbench/tune/findings/findings_controller.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kMostRules = 6;  // buttons that fit beside the others

// A button may be the one whose click led here.
void clear(QLayout& layout) {
  while (QLayoutItem* const item = layout.takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
}

}  // namespace

FixCard::FixCard(FindingsController& findings, QWidget* parent)
    : QFrame(parent),
      findings_(findings),
      sentence_(new QLabel(this)),
      here_(new QToolButton(this)),
      other_end_(new QToolButton(this)),
      rules_(new QHBoxLayout),
      note_(new QLabel(this)),
      fixes_(new QWidget(this)),
      grid_(new QGridLayout(fixes_)) {
  sentence_->setWordWrap(true);
  sentence_->setTextFormat(Qt::PlainText);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  here_->setToolTip(tr("Move the operating point to the place of this force"));
  other_end_->setText(tr("Go to start"));
  other_end_->setToolTip(tr("Move the operating point to the start of the change of force"));
  rules_->setSpacing(theme::kGrid / 2);
  note_->setWordWrap(true);
  setMuted(*note_);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(theme::kGrid);
  grid_->setVerticalSpacing(theme::kGrid / 2);
  grid_->setColumnStretch(1, 1);

  makeColumn(this, {sentence_, makeRow({other_end_, here_, rules_, spring(1)}, theme::kGrid / 2), note_, fixes_},
             theme::kGrid / 2, {0, theme::kGrid / 2, 0, 0});

  connect(here_, &QToolButton::clicked, this, [this] { findings_.goTo(false); });
  connect(other_end_, &QToolButton::clicked, this, [this] { findings_.goTo(true); });
  connect(&findings_, &FindingsController::chosenChanged, this, &FixCard::showFinding);
  connect(&findings_, &FindingsController::fixesChanged, this, &FixCard::showFixes);
  showFinding();
}

FixCard::~FixCard() = default;

void FixCard::showFinding() {
  const auto chosen = findings_.chosen();
  setVisible(chosen.has_value());
  if (!chosen) return;
  const ShownFinding& shown = findings_.findings()[*chosen];
  sentence_->setText(shown.who + QStringLiteral(" · ") + shown.sentence);
  here_->setVisible(!shown.at.empty());
  here_->setText(shown.other_end.empty() ? tr("Go there") : tr("Go to end"));
  other_end_->setVisible(!shown.other_end.empty());
  showRules();
  showFixes();
}

void FixCard::showRules() {
  clear(*rules_);
  QList<QWidget*> places{other_end_, here_};
  const auto& named = findings_.findings()[*findings_.chosen()].rules;
  const bool one_expert = std::all_of(named.begin(), named.end(),
                                      [&](const RuleOfExpert& rule) { return rule.expert == named.front().expert; });
  for (std::size_t r = 0; r < std::min(named.size(), kMostRules); ++r) {
    auto* button = new QToolButton(this);
    button->setText(one_expert ? tr("Rule %1").arg(named[r].rule + 1)
                               : tr("Rule %1 of %2").arg(named[r].rule + 1).arg(text(named[r].expert)));
    button->setToolTip(tr("Select this rule in the rule editor"));
    button->setObjectName(QStringLiteral("rule_%1").arg(r));
    rules_->addWidget(button);
    places << button;
    connect(button, &QToolButton::clicked, this, [this, r] { findings_.pointAt(r); });
  }
  places_stop_ = std::make_unique<RowStop>(places, nullptr);
}

void FixCard::showFixes() {
  if (!findings_.chosen()) return;
  clear(*grid_);
  const auto& fixes = findings_.fixes();
  QList<QWidget*> buttons;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    // An ampersand of a label is no shortcut.
    auto* button = new QPushButton(QString(fixes[i].text).replace(QLatin1Char('&'), QLatin1String("&&")), fixes_);
    button->setToolTip(fixes[i].what);
    button->setObjectName(QStringLiteral("fix_%1").arg(i));
    button->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    keepFitted(*button, [button] {
      button->setMinimumWidth(button->fontMetrics().horizontalAdvance(button->text()) + 3 * theme::kGrid);
    });
    auto* effect = new ElidedLabel(fixes_);
    effect->setFullText(fixes[i].effect);
    setMuted(*effect);
    effect->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    grid_->addWidget(button, static_cast<int>(i), 0);
    grid_->addWidget(effect, static_cast<int>(i), 1);
    connect(button, &QPushButton::clicked, this, [this, i] { findings_.apply(i); });
    buttons << button;
  }
  fixes_stop_ = std::make_unique<RowStop>(buttons, nullptr, Qt::Vertical);
  fixes_->setVisible(!fixes.empty());
  note_->setVisible(fixes.empty());
  if (!findings_.isCurrent()) {
    note_->setText(tr("The model changed: looking again…"));
  } else if (findings_.isLookingForFixes()) {
    note_->setText(tr("Looking for what would settle it…"));
  } else {
    note_->setText(tr("No edit settles this by itself: look at the rules together with the expert."));
  }
}

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

  // With much room the choices stay at the left.
  auto* head = makeRow({{kind_, 30}, {who_, 20}, {order_, 20}, spring(1)});
  makeColumn(this, {head, state_, {body_, 1}, new FixCard(findings_, this), range_}, theme::kGrid, inset(theme::kGrid));
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
