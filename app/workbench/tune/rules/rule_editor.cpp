#include "app/workbench/tune/rules/rule_editor.h"

#include <QComboBox>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabBar>
#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_grid_pane.h"
#include "app/workbench/tune/rules/rule_list_pane.h"

namespace tactus::workbench {
namespace {

constexpr int kTall = 760;  // px, with room for the grids and a list below them

// Fills a box with texts and ids, where they differ from those it has.
void fill(QComboBox& box, const QStringList& texts, const QStringList& ids, const QString& chosen) {
  const QSignalBlocker no_signal(&box);
  bool same = box.count() == texts.size();
  for (int i = 0; same && i < box.count(); ++i) same = box.itemText(i) == texts[i] && box.itemData(i) == ids[i];
  if (!same) {
    box.clear();
    for (qsizetype i = 0; i < texts.size(); ++i) box.addItem(texts[i], ids[i]);
  }
  box.setCurrentIndex(box.findData(chosen));
}

}  // namespace

RuleEditor::RuleEditor(RuleController& rules, QWidget* parent)
    : Card(parent),
      rules_(rules),
      experts_(new QComboBox(this)),
      columns_(new QComboBox(this)),
      tabs_(new QTabBar(this)),
      panes_(new QSplitter(Qt::Vertical, this)),
      refresh_(new Refresh(this, [this] { showHead(); })) {
  experts_->setAccessibleName(tr("Whose rules"));
  experts_->setToolTip(tr("Choose the expert whose rules are edited"));
  columns_->setAccessibleName(tr("Input of the columns"));
  columns_->setToolTip(tr("Choose the input that the grids cross with each other one"));
  for (QComboBox* box : {experts_, columns_}) box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  tabs_->setExpanding(false);
  tabs_->setUsesScrollButtons(false);
  tabs_->addTab(tr("Grids"));
  tabs_->addTab(tr("All rules"));
  tabs_->setAccessibleName(tr("Grids or list"));
  new TabLook(*tabs_);
  // One rule stands in a grid, several or one of another form in the list.
  connect(&rules_.selection(), &Selection::rulesPointed, this, [this] {
    const auto rule = rules_.selection().rule();
    if (!rule || !rules_.cellOf(*rule)) tabs_->setCurrentIndex(1);
  });
  panes_->addWidget(new RuleGridPane(rules, this));
  panes_->addWidget(new RuleListPane(rules, this));
  panes_->setChildrenCollapsible(false);
  panes_->setHandleWidth(theme::kGrid);
  panes_->widget(1)->hide();

  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid);
  head->addWidget(experts_);
  head->addWidget(columns_);
  head->addStretch(1);
  head->addWidget(tabs_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(6);
  layout->addLayout(head);
  layout->addWidget(panes_, 1);

  connect(tabs_, &QTabBar::currentChanged, this, &RuleEditor::arrange);
  connect(experts_, &QComboBox::activated, this,
          [this](int index) { rules_.setExpert(experts_->itemData(index).toString().toStdString()); });
  connect(columns_, &QComboBox::activated, this,
          [this](int index) { rules_.setRegion(columns_->itemData(index).toString().toStdString()); });
  connect(&rules_, &RuleController::rulesChanged, refresh_, &Refresh::request);
  // At once: what is disabled until it was painted refuses the keyboard that a click on a rule elsewhere hands to it.
  connect(&rules_, &RuleController::rulesChanged, this, [this] { setEnabled(rules_.isOpen()); });
  setEnabled(rules_.isOpen());
  arrange();
  refresh_->request();
}

void RuleEditor::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  const bool tall = height() >= kTall;
  if (tall == tall_) return;
  tall_ = tall;
  arrange();
  if (tall_) panes_->setSizes({3 * height() / 5, 2 * height() / 5});
}

void RuleEditor::arrange() {
  const bool list = tabs_->currentIndex() == 1;
  tabs_->setVisible(!tall_);
  columns_->setVisible(tall_ || !list);
  panes_->widget(0)->setVisible(tall_ || !list);
  panes_->widget(1)->setVisible(tall_ || list);
  // The keys that answer are those of the rules.
  setFocusProxy(panes_->widget(list && !tall_ ? 1 : 0));
}

void RuleEditor::showHead() {
  if (!rules_.isOpen()) return;
  const fuzzy::ForceModel& model = rules_.model();
  QStringList texts;
  QStringList ids;
  for (const fuzzy::Expert& expert : model.experts) {
    texts << labelOf(expert);
    ids << text(expert.id);
  }
  fill(*experts_, texts, ids, text(rules_.expert().id));
  texts.clear();
  ids.clear();
  for (const fuzzy::Variable& input : model.inputs) {
    texts << tr("Columns: %1").arg(labelOf(input));
    ids << text(input.id);
  }
  fill(*columns_, texts, ids, text(rules_.region()));
  tabs_->setTabText(1, tr("All rules (%1)").arg(rules_.expert().rules.size()));
}

}  // namespace tactus::workbench
