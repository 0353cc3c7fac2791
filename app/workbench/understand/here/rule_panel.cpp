#include "app/workbench/understand/here/rule_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/selection.h"
#include "app/workbench/plot/plot_caption.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/here/expert_flow.h"
#include "app/workbench/understand/here/output_sets_plot.h"
#include "app/workbench/understand/here/rule_flow.h"

namespace tactus::workbench {

RulePanel::RulePanel(const SceneController& scene, Selection& selection, QWidget* parent)
    : Card(parent),
      scene_(scene),
      selection_(selection),
      who_(new QComboBox(this)),
      summary_(new ElidedLabel(this)),
      edit_(new QToolButton(this)),
      area_(new QScrollArea(this)),
      flows_(new QStackedWidget),
      rules_(new RuleFlow),
      experts_(new ExpertFlow(scene)),
      sets_(new OutputSetsPlot(this)),
      refresh_(new Refresh(this, [this] { explain(); })) {
  who_->setAccessibleName(tr("Whose rules are shown"));
  who_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  summary_->setFont(theme::headingFont());
  flows_->addWidget(experts_);
  flows_->addWidget(rules_);
  area_->setFrameShape(QFrame::NoFrame);
  area_->setWidgetResizable(true);
  area_->setWidget(flows_);
  area_->viewport()->setAutoFillBackground(false);
  flows_->setAutoFillBackground(false);

  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid);
  head->addWidget(who_);
  head->addWidget(summary_, 1);
  head->addWidget(edit_);
  head->addWidget(new PlotMenu(
      *sets_, [this] { return table(); }, this));
  auto* body = new QHBoxLayout;
  body->setSpacing(theme::kGrid);
  body->addWidget(area_, 2);
  body->addWidget(sets_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addLayout(head);
  layout->addLayout(body, 1);

  edit_->setToolTip(tr("Open the selected rule in the rule editor (Enter, or a double click on it)"));
  connect(who_, &QComboBox::activated, this, &RulePanel::chooseByHand);
  connect(rules_, &RuleFlow::chosen, this, &RulePanel::point);
  connect(rules_, &RuleFlow::editAsked, this, [this](std::size_t rule) {
    point(rule);
    selection_.editRules();
  });
  connect(edit_, &QToolButton::clicked, &selection_, &Selection::editRules);
  connect(&selection_, &Selection::expertChanged, this, &RulePanel::adoptExpert);
  connect(&selection_, &Selection::rulesChanged, refresh_, &Refresh::request);
  connect(experts_, &ExpertFlow::chosen, this,
          [this](std::size_t expert) { chooseByHand(static_cast<int>(expert) + 1); });
  connect(&scene_, &SceneController::modelChanged, this, &RulePanel::adoptModel);
  connect(&scene_, &SceneController::modelEdited, refresh_, &Refresh::request);
  connect(&scene_, &SceneController::readingChanged, refresh_, &Refresh::request);
}

void RulePanel::adoptModel() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const QVariant chosen = who_->currentData();
  who_->clear();
  who_->addItem(tr("Mean"), QString());
  for (const fuzzy::Expert& expert : model.experts) who_->addItem(labelOf(expert), text(expert.id));
  // With one expert the mean is that expert, whose rules say more. Otherwise who was looked at stays.
  const int row = model.experts.size() == 1 ? 1 : who_->findData(chosen);
  choose(std::max(row, 0));
}

// Who looks at the rules of one expert looks at those of the other one next; the mean stays the mean.
void RulePanel::adoptExpert() {
  const int row = who_->findData(text(selection_.expert()));
  if (row > 0 && who_->currentIndex() > 0 && row != who_->currentIndex()) choose(row);
}

void RulePanel::point(std::size_t rule) {
  // Another version that is compared has rules of its own.
  if (scene_.showsAnother()) return;
  selection_.pointAtRules(who_->currentData().toString().toStdString(), {rule});
}

void RulePanel::showSelected() {
  const bool these =
      who_->currentIndex() > 0 && !scene_.showsAnother() && who_->currentData().toString() == text(selection_.expert());
  rules_->setSelected(these ? selection_.rules() : std::vector<std::size_t>());
  const auto rule = these ? selection_.rule() : std::nullopt;
  edit_->setVisible(rule.has_value());
  if (rule) edit_->setText(tr("Edit rule %1").arg(*rule + 1));
}

void RulePanel::chooseByHand(int row) {
  choose(row);
  if (row > 0) selection_.setExpert(who_->currentData().toString().toStdString());
}

void RulePanel::choose(int row) {
  who_->setCurrentIndex(row);
  flows_->setCurrentIndex(row == 0 ? 0 : 1);
  // Only the one that is seen asks for room.
  for (int page = 0; page < flows_->count(); ++page) {
    const auto policy = page == flows_->currentIndex() ? QSizePolicy::Expanding : QSizePolicy::Ignored;
    flows_->widget(page)->setSizePolicy(policy, policy);
  }
  area_->verticalScrollBar()->setValue(0);
  refresh_->request();
}

void RulePanel::explain() {
  const analysis::Explanation& explanation = scene_.explanation();
  const int row = who_->currentIndex();
  if (row == 0) {
    experts_->follow();
    sets_->showExperts(scene_.model()->model, explanation);
  } else {
    const auto expert = static_cast<std::size_t>(row) - 1;
    rules_->set(scene_.shared(), explanation, expert);
    sets_->showExpert(scene_.model()->model, explanation, expert);
  }
  showSelected();
  summary_->setFullText(summary());
}

QString RulePanel::summary() const {
  const analysis::Explanation& explanation = scene_.explanation();
  if (who_->currentIndex() == 0) {
    const auto speaking = std::count_if(explanation.experts.begin(), explanation.experts.end(),
                                        [](const auto& expert) { return !expert.abstains; });
    if (speaking == 0) return tr("no rule fires");
    return tr("%1 of %n expert(s) speak · mean %2", nullptr, static_cast<int>(explanation.experts.size()))
        .arg(speaking)
        .arg(forceText(explanation.force_n, scene_.model()->model.output.unit));
  }
  const analysis::ExplainedExpert& expert = explanation.experts[static_cast<std::size_t>(who_->currentIndex()) - 1];
  if (expert.abstains) return tr("no rule fires");
  const auto acting =
      std::count_if(expert.rules.begin(), expert.rules.end(), [](const auto& rule) { return rule.strength > 0; });
  return tr("%1 of %n rule(s) act · %2", nullptr, static_cast<int>(expert.rules.size()))
      .arg(acting)
      .arg(forceText(expert.force_n, scene_.model()->model.output.unit));
}

PlotTable RulePanel::table() {
  explain();
  const fuzzy::ForceModel& model = scene_.model()->model;
  const int row = who_->currentIndex();
  const QString what =
      row == 0
          ? tr("sets of %1 that the experts' rules make, %2").arg(labelOf(model.output), summary())
          : tr("sets of %1 that the rules of %2 make, %3").arg(labelOf(model.output), who_->currentText(), summary());
  // What is read may be the place under the mouse.
  const std::vector<double> point = scene_.readingPoint();
  QStringList parts;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < point.size(); ++i) {
    parts << labelOf(model.inputs[i]) + QLatin1Char(' ') + exactText(point[i], model.inputs[i].unit);
    all.push_back(i);
  }
  PlotTable out =
      captionedTable(scene_, what, all, {parts.join(QStringLiteral(" · "))}, QStringLiteral("-output-sets"));
  sets_->fillTable(out);
  return out;
}

}  // namespace tactus::workbench
