#include "app/workbench/understand/here/rule_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/selection.h"
#include "app/workbench/plot/chart.h"
#include "app/workbench/plot/plot_caption.h"
#include "app/workbench/plot/plot_marks.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/understand/here/variable_row.h"
#include "core/base/error.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::workbench {
namespace {

constexpr double kExpertHeight = 50;  // px, the least height of an expert
constexpr double kRoomAround = 13;    // px above and below its two lines
constexpr double kDot = 10;           // px
constexpr double kForces = 120;       // px, the least width of force and share
constexpr double kNarrowestSketch = 90;
constexpr int kNarrowestFlow = 340;  // px, of all

// Both lines have their room whatever the size of the text.
double expertHeight() {
  return std::max(kExpertHeight, kRoomAround + QFontMetrics(theme::headingFont()).height() +
                                     QFontMetrics(theme::smallFont()).height());
}

double forcesWidth() {
  const QString share = ExpertFlow::tr("× %1 = %2").arg(QStringLiteral("0.333"), QStringLiteral("0.000 N"));
  return std::max(kForces, QFontMetrics(theme::smallFont()).horizontalAdvance(share) + 2.0 * theme::kGrid);
}

}  // namespace

ExpertFlow::ExpertFlow(const SceneController& scene, QWidget* parent) : QWidget(parent), scene_(scene) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
  setCursor(Qt::PointingHandCursor);
}

std::size_t ExpertFlow::count() const { return scene_.model() ? scene_.model()->model.experts.size() : 0; }

void ExpertFlow::refreshState() {
  updateGeometry();
  update();
}

QSize ExpertFlow::sizeHint() const { return {640, static_cast<int>(expertHeight() * static_cast<double>(count()))}; }

QSize ExpertFlow::minimumSizeHint() const { return {kNarrowestFlow, sizeHint().height()}; }

void ExpertFlow::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  // Of many experts only those in sight.
  const auto first = static_cast<std::size_t>(std::max(0.0, event->rect().top() / expertHeight()));
  const auto last = static_cast<std::size_t>(std::max(0.0, event->rect().bottom() / expertHeight()));
  for (std::size_t expert = first; expert < count() && expert <= last; ++expert) {
    paintLine(painter, expert);
  }
}

void ExpertFlow::mousePressEvent(QMouseEvent* event) {
  const auto line = static_cast<std::size_t>(std::max(0.0, event->position().y()) / expertHeight());
  if (event->button() == Qt::LeftButton && line < count()) emit chosen(line);
}

void ExpertFlow::paintLine(QPainter& painter, std::size_t expert) const {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const analysis::ExplainedExpert& explained = scene_.explanation().experts[expert];
  const double height = expertHeight();
  const double forces_width = forcesWidth();
  const QRectF line(0, height * static_cast<double>(expert), width(), height);
  if (expert % 2 == 0) painter.fillRect(line, theme::window());
  const QColor color = theme::expert(figures::expertNumbers(model.experts)[expert]);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(QRectF(4, line.center().y() - kDot / 2, kDot, kDot));

  const double sketch_width = std::max(kNarrowestSketch, (width() - forces_width) * 0.25);
  const QRectF words(4 + kDot + theme::kGrid, line.top() + 5, width() - forces_width - sketch_width - kDot - 28,
                     height - 10);
  painter.setPen(theme::ink());
  painter.setFont(theme::headingFont());
  painter.drawText(words, Qt::AlignLeft | Qt::AlignTop,
                   painter.fontMetrics().elidedText(labelOf(model.experts[expert]), Qt::ElideRight,
                                                    static_cast<int>(words.width())));
  painter.setPen(theme::mutedInk());
  painter.setFont(theme::smallFont());
  painter.drawText(
      words, Qt::AlignLeft | Qt::AlignBottom,
      painter.fontMetrics().elidedText(strongestRule(expert), Qt::ElideRight, static_cast<int>(words.width())));

  const QRectF forces(line.right() - forces_width, line.top() + 5, forces_width - theme::kGrid, height - 10);
  SetSketch sketch(painter, QRectF(forces.left() - sketch_width, line.top() + 4, sketch_width - 8, height - 9),
                   model.output);
  sketch.ground();
  if (explained.abstains) {
    painter.setPen(theme::mutedInk());
    painter.drawText(forces, Qt::AlignRight | Qt::AlignVCenter, tr("no rule fires"));
    return;
  }
  sketch.set(explained.aggregated, color);
  sketch.mark(explained.force_n, theme::ink());
  painter.setPen(theme::ink());
  painter.setFont(theme::headingFont());
  painter.drawText(forces, Qt::AlignRight | Qt::AlignTop, forceText(explained.force_n, model.output.unit));
  painter.setPen(theme::mutedInk());
  painter.setFont(theme::smallFont());
  painter.drawText(
      forces, Qt::AlignRight | Qt::AlignBottom,
      tr("× %1 = %2")
          .arg(numberText(explained.weight_share, 3), forceText(explained.contribution_n, model.output.unit)));
}

QString ExpertFlow::strongestRule(std::size_t expert) const {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const std::vector<analysis::ExplainedRule>& rules = scene_.explanation().experts[expert].rules;
  const auto strongest = std::max_element(
      rules.begin(), rules.end(), [](const auto& one, const auto& other) { return one.strength < other.strength; });
  if (strongest == rules.end() || strongest->strength <= 0) return {};
  const auto acting = std::count_if(rules.begin(), rules.end(), [](const auto& rule) { return rule.strength > 0; });
  const fuzzy::Expert& said = model.experts[expert];
  const fuzzy::Rule& rule = said.rules[strongest->rule];
  // The terms alone; the variables stand in the rule viewer of the expert.
  QStringList terms;
  for (const fuzzy::Condition& condition : rule.conditions) {
    const auto input = std::find_if(model.inputs.begin(), model.inputs.end(),
                                    [&condition](const auto& variable) { return variable.id == condition.input; });
    terms << labelOf(*fuzzy::findTerm(fuzzy::termsFor(said, *input), condition.term));
  }
  const QString words = terms.join(QStringLiteral(", ")) + QStringLiteral(" → ") +
                        labelOf(*fuzzy::findTerm(fuzzy::termsFor(said, model.output), rule.then));
  return acting == 1 ? words : tr("%n rule(s) · %1", nullptr, static_cast<int>(acting)).arg(words);
}

namespace {

constexpr std::size_t kMostFills = 12;

using ReasonsFound = Computed<int, analysis::Reasons>::Answer;

/// Also for inputs that have moved since, so that a drag shows numbers.
ReasonsFound reasonsAt(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                       const std::vector<double>& point, std::optional<std::size_t> expert,
                       const RunOf<analysis::Reasons>& run) {
  auto explanation = analysis::explain(model, compiled, point);
  if (!explanation) return tl::unexpected(text(explanation.error().message()));
  auto found = analysis::reasonsOf(model, compiled, *explanation, elicitation::justNoticeableDifference, expert);
  if (!found) return tl::unexpected(text(found.error().message()));
  run.show(std::move(*found));
  return nullptr;
}

Chart setsOf(const fuzzy::Variable& output) {
  return {{.universe = output, .label = axisText(output), .grid = false}, membershipAxis()};
}

void addSet(Chart& chart, const QString& name, const analysis::Polyline& set, const QColor& color, float fill_alpha,
            double width) {
  if (set.empty()) return;
  QVector<double> x{set.front().x};
  QVector<double> height{0};
  for (const analysis::Vertex& vertex : set) {
    x << vertex.x;
    height << vertex.height;
  }
  x << set.back().x;
  height << 0;
  const ChartLine line = filledLine(x, height, color, width, fill_alpha);
  chart.parts.emplace_back(line);
  chart.legend.push_back({name, line.pen, line.fill});
}

}  // namespace

OutputSetsPlot::OutputSetsPlot(QWidget* parent) : ChartView(parent, {800, 420}) {
  setMinimumSize(200, 120);
  setAccessibleName(tr("Clipped sets of the output and their centroid"));
  cursor_ = new ReadingCursor(plot());
  plot().axisRect()->setMinimumMargins(QMargins(0, theme::kGrid / 2, 2 * theme::kGrid, 0));
}

void OutputSetsPlot::showExpert(const fuzzy::ForceModel& model, const analysis::Explanation& explanation,
                                std::size_t expert) {
  Chart sets = setsOf(model.output);
  const analysis::ExplainedExpert& explained = explanation.experts[expert];
  const std::vector<fuzzy::Term>& terms = fuzzy::termsFor(model.experts[expert], model.output);
  for (std::size_t i = 0; i < explained.output_terms.size(); ++i) {
    addSet(sets, labelOf(terms[i]), explained.output_terms[i].set, theme::force(i, explained.output_terms.size()),
           0.45F, 1);
  }
  addSet(sets, tr("together"), explained.aggregated, theme::ink(), 0, 1.6);
  showSets(std::move(sets), !explained.abstains, explained.force_n,
           tr("centroid %1").arg(forceText(explained.force_n, model.output.unit)));
}

void OutputSetsPlot::showExperts(const fuzzy::ForceModel& model, const analysis::Explanation& explanation) {
  Chart sets = setsOf(model.output);
  // Many fills over each other say nothing any more, and outlines are enough.
  const bool many = explanation.experts.size() > kMostFills;
  const std::vector<std::size_t> numbers = figures::expertNumbers(model.experts);
  for (std::size_t i = 0; i < explanation.experts.size(); ++i) {
    addSet(sets, labelOf(model.experts[i]), explanation.experts[i].aggregated, theme::expert(numbers[i]),
           many ? 0 : 0.1F, many ? 1 : 1.6);
  }
  showSets(std::move(sets), explanation.fired, explanation.force_n,
           tr("mean %1").arg(forceText(explanation.force_n, model.output.unit)));
}

// The force at the centroid is what the plot is about, so its mark stays in a picture.
void OutputSetsPlot::showSets(Chart sets, bool fired, double force_n, const QString& tag) {
  cursor_->setVisible(fired);
  cursor_->set(force_n, tag, {});
  setChart(std::move(sets));
}

void OutputSetsPlot::fillTable(PlotTable& table) const {
  table.columns = {"set", columnName(chart().x.universe), "height"};
  for (std::size_t i = 0; i < chart().parts.size(); ++i) {
    const auto& set = std::get<ChartLine>(chart().parts[i]);
    const std::string name = chart().legend[i].name.toStdString();
    for (qsizetype corner = 0; corner < set.x.size(); ++corner)
      table.rows.push_back({name, set.x[corner], set.y[corner]});
  }
}

RulePanel::RulePanel(const SceneController& scene, Selection& selection, QWidget* parent)
    : Card(parent),
      scene_(scene),
      selection_(selection),
      who_(new QComboBox(this)),
      summary_(new ElidedLabel(this)),
      edit_(new QToolButton(this)),
      area_(new QScrollArea(this)),
      flows_(new QStackedWidget),
      sentence_(new QLabel),
      why_(new WhyView),
      rules_(new RuleFlow),
      experts_(new ExpertFlow(scene)),
      sets_(new OutputSetsPlot(this)),
      refresh_(new Refresh(this, [this] { explain(); })),
      reasons_(new Computed<WhyPlace, analysis::Reasons>([this] { return asked_; },
                                                         [](const WhyPlace& at, const RunOf<analysis::Reasons>& run) {
                                                           return reasonsAt(at.open->model, at.open->compiled, at.point,
                                                                            at.expert, run);
                                                         },
                                                         this)) {
  who_->setAccessibleName(tr("Whose rules are shown"));
  who_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  summary_->setFont(theme::headingFont());
  flows_->addWidget(experts_);
  flows_->addWidget(rules_);
  area_->setFrameShape(QFrame::NoFrame);
  area_->setWidgetResizable(true);
  sentence_->setTextFormat(Qt::PlainText);
  sentence_->setWordWrap(true);
  sentence_->setContentsMargins(theme::kGrid / 2, 0, theme::kGrid / 2, 0);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* const content = new QWidget;
  makeColumn(content, {sentence_, why_, {flows_, 1}});
  area_->setWidget(content);
  content->setAutoFillBackground(false);
  area_->viewport()->setAutoFillBackground(false);
  flows_->setAutoFillBackground(false);

  makeColumn(this,
             {makeRow({who_,
                       {summary_, 1},
                       edit_,
                       new PlotMenu(
                           *sets_, [this] { return table(); }, this)}),
              {makeRow({{area_, 2}, {sets_, 1}}), 1}},
             theme::kGrid, {theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid});

  edit_->setToolTip(tr("Open the selected rule in the rule editor (Enter, or a double click on it)"));
  connect(who_, &QComboBox::activated, this, &RulePanel::chooseByHand);
  reasons_->hold(*this);  // `refresh_` asks only while the panel is visible
  connect(reasons_, &Computation::changed, this, [this] { refresh_->setRefining(reasons_->isBusy()); });
  connect(reasons_, &Computation::valueChanged, this, &RulePanel::showWhy);
  connect(why_, &WhyView::wordChosen, this, &RulePanel::showRulesOf);
  connect(why_, &WhyView::expertChosen, this,
          [this](std::size_t expert) { chooseByHand(static_cast<int>(expert) + 1); });
  connect(why_, &WhyView::ruleChosen, this, [this](std::size_t expert, std::size_t rule) { pointOf(expert, {rule}); });
  connect(why_, &WhyView::editAsked, this, [this](std::size_t expert, std::size_t rule) {
    pointOf(expert, {rule});
    selection_.editRules();
  });
  connect(why_, &WhyView::answerAsked, this, [this](std::size_t expert, std::size_t rule) {
    const fuzzy::Expert& who = scene_.model()->model.experts[expert];
    emit answerAsked(who.id, who.rules[rule]);
  });
  connect(why_, &WhyView::termAsked, this, [this](const editing::TermPlace& place) {
    if (!scene_.showsAnother()) selection_.editTerm(place);
  });
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

void RulePanel::pointOf(std::size_t expert, const std::vector<std::size_t>& rules) {
  if (scene_.showsAnother() || rules.empty() || expert >= scene_.model()->model.experts.size()) return;
  selection_.pointAtRules(scene_.model()->model.experts[expert].id, rules);
}

// The list below has the rules of one expert; of the mean the rules stand below the word itself.
void RulePanel::showRulesOf(const std::string& term) {
  if (who_->currentIndex() <= 0) return;
  const auto expert = static_cast<std::size_t>(who_->currentIndex()) - 1;
  pointOf(expert, why_->rulesOf(expert, term));
  showSelected();
  if (const int bottom = rules_->selectedBottom(); bottom > 0) {
    area_->ensureVisible(0, flows_->y() + bottom, 0, theme::kGrid / 2);
  }
}

RulePanel::WhyPlace RulePanel::whyPlace() const {
  const int row = who_->currentIndex();
  return {scene_.shared(), scene_.readingPoint(),
          row > 0 ? std::optional(static_cast<std::size_t>(row) - 1) : std::nullopt};
}

void RulePanel::askWhy() {
  WhyPlace place = whyPlace();
  if (asked_ == place) return;
  asked_ = std::move(place);
  reasons_->refresh();
  refresh_->setRefining(reasons_->isBusy());
}

void RulePanel::showWhy() {
  if (!reasons_->value()) {
    sentence_->setText(reasons_->failure());
    why_->clear();
    return;
  }
  sentence_->setText(text(analysis::sentenceOf(reasons_->of()->open->model, *reasons_->value())));
  const WhyPlace& of = *reasons_->of();
  why_->set(of.open, of.point, of.expert, reasons_->value());
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
    experts_->refreshState();
    sets_->showExperts(scene_.model()->model, explanation);
  } else {
    const auto expert = static_cast<std::size_t>(row) - 1;
    rules_->set(scene_.shared(), explanation, expert);
    sets_->showExpert(scene_.model()->model, explanation, expert);
  }
  showSelected();
  summary_->setFullText(summary());
  askWhy();
}

QString RulePanel::summary() const {
  const analysis::Explanation& explanation = scene_.explanation();
  if (who_->currentIndex() == 0) {
    const auto speaking = std::count_if(explanation.experts.begin(), explanation.experts.end(),
                                        [](const auto& expert) { return !expert.abstains; });
    if (speaking == 0) return tr("no rule fires");
    return tr("%1 of %n expert(s) have a rule here · mean %2", nullptr, static_cast<int>(explanation.experts.size()))
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
