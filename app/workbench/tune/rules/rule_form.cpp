#include <QComboBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_editor.h"
#include "app/workbench/tune/rules/rule_weight.h"

namespace tactus::workbench {
namespace {

// The terms of a list with their ids; what was chosen stays where it is still there.
void fillTerms(QComboBox& box, const std::vector<fuzzy::Term>& terms, bool with_any) {
  const QString chosen = box.currentData().toString();
  const QSignalBlocker no_signal(&box);
  box.clear();
  if (with_any) box.addItem(RuleForm::tr("any"), QString());
  for (const fuzzy::Term& term : terms) box.addItem(labelOf(term), text(term.id));
  box.setCurrentIndex(std::max(0, box.findData(chosen)));
}

void choose(QComboBox& box, const std::string& id) { box.setCurrentIndex(std::max(0, box.findData(text(id)))); }

}  // namespace

RuleForm::RuleForm(RuleController& rules, QWidget* parent)
    : QFrame(parent),
      rules_(rules),
      title_(new QLabel(this)),
      lines_place_(new QWidget(this)),
      lines_grid_(new QGridLayout(lines_place_)),
      then_label_(new QLabel(this)),
      then_(new QComboBox(this)),
      weight_(makeWeightBox(this)),
      accept_(new QPushButton(this)),
      message_(new QLabel(this)) {
  setFrameShape(QFrame::StyledPanel);
  title_->setFont(theme::headingFont());
  then_->setAccessibleName(tr("Consequent of the rule"));
  weight_->setAccessibleName(tr("Weight of the rule"));
  message_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  message_->setAccessibleName(tr("The problem with the rule"));
  lines_grid_->setContentsMargins(0, 0, 0, 0);
  lines_grid_->setHorizontalSpacing(theme::kGrid);
  lines_grid_->setVerticalSpacing(4);
  auto* close = new QToolButton(this);
  close->setText(QStringLiteral("✕"));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close the form"));
  close->setAccessibleName(tr("Close the form"));

  auto* head = makeRow({{title_, 1}, close}, kStyleGap);
  auto* last =
      makeRow({then_label_, then_, gap(theme::kGrid), new QLabel(tr("Weight"), this), weight_, spring(1), accept_});
  makeColumn(this, {head, lines_place_, last, message_}, 6, {theme::kGrid, 4, theme::kGrid, theme::kGrid});
  hide();

  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  connect(accept_, &QPushButton::clicked, this, &RuleForm::accept);
}

void RuleForm::openNew() {
  target_.reset();
  fill();
  show(fuzzy::Rule());
}

void RuleForm::openFor(std::size_t rule) {
  target_ = rule;
  before_ = rules_.expert().rules[rule];
  fill();
  show(before_);
}

void RuleForm::show(const fuzzy::Rule& rule) {
  for (Line& line : lines_) {
    const auto condition = std::find_if(rule.conditions.begin(), rule.conditions.end(),
                                        [&](const fuzzy::Condition& one) { return one.input == line.input; });
    choose(*line.terms, condition == rule.conditions.end() ? std::string() : condition->term);
  }
  choose(*then_, rule.then);
  weight_->setExact(rule.weight);
  say({}, false);
  showTarget();
  QFrame::show();
  if (!lines_.empty()) lines_.front().terms->setFocus();
}

void RuleForm::refreshState() {
  if (isHidden() || !rules_.isOpen()) return;
  fill();
  if (target_) {
    // Undo or an edit elsewhere may have moved the rule, or taken it away.
    const auto& all = rules_.expert().rules;
    const bool there = *target_ < all.size() && all[*target_] == before_;
    const auto found =
        there ? all.begin() + static_cast<std::ptrdiff_t>(*target_) : std::find(all.begin(), all.end(), before_);
    target_ = found == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
  }
  showTarget();
}

void RuleForm::fill() {
  const auto& inputs = rules_.model().inputs;
  const bool same = std::equal(lines_.begin(), lines_.end(), inputs.begin(), inputs.end(),
                               [](const Line& line, const fuzzy::Variable& input) { return line.input == input.id; });
  if (!same) buildLines();
  for (Line& line : lines_) fillTerms(*line.terms, rules_.terms(line.input), true);
  fillTerms(*then_, rules_.words(), false);
  then_label_->setText(tr("Then %1 is").arg(labelOf(rules_.model().output)));
}

void RuleForm::buildLines() {
  qDeleteAll(lines_place_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
  lines_.clear();
  const auto& inputs = rules_.model().inputs;
  const auto rows = static_cast<int>((inputs.size() + 1) / 2);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const int row = static_cast<int>(i) % rows;
    const int column = static_cast<int>(i) / rows * 2;
    auto* label = new QLabel(labelOf(inputs[i]), lines_place_);
    auto* terms = new QComboBox(lines_place_);
    terms->setAccessibleName(labelOf(inputs[i]));
    terms->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    label->setBuddy(terms);
    lines_grid_->addWidget(label, row, column);
    lines_grid_->addWidget(terms, row, column + 1);
    lines_grid_->setColumnStretch(column + 1, 1);
    lines_.push_back({inputs[i].id, terms});
  }
}

void RuleForm::showTarget() {
  title_->setText(target_ ? tr("Rule %1").arg(*target_ + 1) : tr("New rule"));
  accept_->setText(target_ ? tr("Rewrite rule %1").arg(*target_ + 1) : tr("Add rule"));
}

void RuleForm::say(const QString& sentence, bool refused) {
  QPalette colors;
  if (refused) colors.setColor(QPalette::WindowText, theme::errorInk());
  message_->setPalette(colors);
  message_->setText(sentence);
  message_->setVisible(!sentence.isEmpty());
}

fuzzy::Rule RuleForm::typed() const {
  fuzzy::Rule rule;
  for (const Line& line : lines_) {
    const std::string term = line.terms->currentData().toString().toStdString();
    if (!term.empty()) rule.conditions.push_back({line.input, term});
  }
  rule.then = then_->currentData().toString().toStdString();
  rule.weight = weight_->exact();
  if (target_) rule.enabled = before_.enabled;
  return rule;
}

void RuleForm::accept() {
  if (!weight_->commit()) {
    say(weight_->refusal(), true);
    return;
  }
  const fuzzy::Rule rule = typed();
  const auto target = target_;
  const auto ok = target ? rules_.replace(*target, rule) : rules_.add(rule);
  if (!ok) {
    say(text(ok.error().message()), true);
    return;
  }
  const auto& all = rules_.expert().rules;
  if (target) {
    hide();
    emit done(*target);
  } else {
    say(tr("Added as rule %1.").arg(all.size()), false);
    emit done(all.size() - 1);
  }
}

void RuleForm::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    accept_->click();
  } else if (event->key() == Qt::Key_Escape) {
    hide();
  } else {
    QFrame::keyPressEvent(event);
  }
}

}  // namespace tactus::workbench
