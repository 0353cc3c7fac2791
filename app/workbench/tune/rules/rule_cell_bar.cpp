#include "app/workbench/tune/rules/rule_cell_bar.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_weight.h"
#include "app/workbench/tune/rules/word_bar.h"

namespace tactus::workbench {

RuleCellBar::RuleCellBar(RuleController& rules, QWidget* parent)
    : QWidget(parent),
      rules_(rules),
      conditions_(new ElidedLabel(this)),
      weight_(makeWeightBox(this)),
      enabled_(new QCheckBox(tr("Enabled"), this)),
      words_(new WordBar(this)) {
  conditions_->setFont(theme::smallFont());
  weight_->setAccessibleName(tr("Weight of the selected rule"));
  enabled_->setAccessibleName(tr("The selected rule is enabled"));
  // A click leaves the keys with the grids.
  enabled_->setFocusPolicy(Qt::TabFocus);
  auto* first = new QHBoxLayout;
  first->setSpacing(theme::kGrid);
  first->addWidget(conditions_, 1);
  first->addWidget(new QLabel(tr("Weight"), this));
  first->addWidget(weight_);
  first->addWidget(enabled_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(first);
  layout->addWidget(words_);

  connect(words_, &WordBar::chosen, &rules_, &RuleController::answerAndGoOn);
  connect(words_, &WordBar::cleared, &rules_, [this] { rules_.answer(std::nullopt); });
  connect(weight_, &NumberBox::valueChanged, this, [this](double weight) {
    const auto cell = rules_.selected();
    if (cell && rules_.cell(*cell).rule) rules_.weigh(*rules_.cell(*cell).rule, weight);
  });
  connect(weight_, &NumberBox::editingFinished, this, [this] {
    rules_.endWeighing();
    if (weight_->hasFocus()) emit done();
  });
  connect(enabled_, &QCheckBox::clicked, this, [this](bool on) {
    const auto cell = rules_.selected();
    if (cell && rules_.cell(*cell).rule) rules_.enable({*rules_.cell(*cell).rule}, on);
  });
}

void RuleCellBar::showCell() {
  if (!rules_.isOpen()) return;
  const auto selected = rules_.selected();
  words_->setWords(rules_.words());
  words_->setEnabled(selected.has_value());
  const editing::GridCell none;
  const editing::GridCell& cell = selected ? rules_.cell(*selected) : none;
  QString sentence = selected ? rules_.conditionsOf(*selected) : tr("Click a cell to answer it.");
  if (cell.conflict) {
    sentence = tr("Conflict with a rule for %1. Choose an answer to resolve it. %2")
                   .arg(rules_.otherAnswers(*selected).join(tr(" and ")), sentence);
  }
  if (cell.conflict != warns_) {
    warns_ = cell.conflict;
    QPalette colors;
    if (warns_) colors.setColor(QPalette::WindowText, theme::warningInk());
    conditions_->setPalette(colors);
  }
  conditions_->setFullText(sentence);
  words_->setAnswer(cell.rule ? rules_.wordOf(cell.then) : std::nullopt);
  weight_->setEnabled(cell.rule.has_value());
  enabled_->setEnabled(cell.rule.has_value());
  const QSignalBlocker no_weight(weight_);
  const QSignalBlocker no_enabled(enabled_);
  // Typed text stays until it is committed.
  if (weight_->exact() != cell.weight) weight_->setExact(cell.weight);
  enabled_->setChecked(cell.rule && cell.enabled);
}

}  // namespace tactus::workbench
