#include "app/workbench/labs/experts/experts_lab_view.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QStandardItemModel>
#include <QTabWidget>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/quiet_table.h"
#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/plot_style.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::workbench {
namespace {

constexpr double kMeanPx = 3.5;

QVector<double> forcesOf(const std::vector<fuzzy::Evaluation>& curve) {
  QVector<double> out;
  out.reserve(static_cast<qsizetype>(curve.size()));
  for (const fuzzy::Evaluation& one : curve) out << (one.fired ? one.force_n : qQNaN());
  return out;
}

}  // namespace

LeaveOneOutPlot::LeaveOneOutPlot(QWidget* parent) : QWidget(parent), plot_(makePlot(this)) {
  plot_->plotLayout()->clear();
  forces_ = new QCPAxisRect(plot_);
  pulls_ = new QCPAxisRect(plot_);
  plot_->plotLayout()->addElement(0, 0, forces_);
  plot_->plotLayout()->addElement(1, 0, pulls_);
  plot_->plotLayout()->setRowStretchFactor(0, 1.3);
  auto* margins = new QCPMarginGroup(plot_);
  for (QCPAxisRect* area : {forces_, pulls_}) {
    area->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    area->setMinimumMargins(QMargins(0, theme::kGrid, 2 * theme::kGrid, 0));
    for (QCPAxis* axis : area->axes()) axis->setLayer(QStringLiteral("axes"));
    for (QCPAxis* axis : area->axes()) axis->grid()->setLayer(QStringLiteral("grid"));
  }
  makeColumn(this, {plot_}, theme::kGrid, inset(theme::kGrid / 2));
  setMinimumSize(320, 220);
  setAccessibleName(tr("Averaged force and the experts' distances from it"));
}

QCPGraph& LeaveOneOutPlot::addLine(QCPAxisRect& area, const QPen& pen) {
  QCPGraph* const graph = plot_->addGraph(area.axis(QCPAxis::atBottom), area.axis(QCPAxis::atLeft));
  graph->setPen(pen);
  graph->setAdaptiveSampling(false);
  return *graph;
}

void LeaveOneOutPlot::clear() {
  plot_->clearGraphs();
  legend_.clear();
  redraw(*plot_);
}

void LeaveOneOutPlot::setCurves(const fuzzy::ForceModel& model, std::size_t x_input,
                                const figures::ForceCurves& curves) {
  plot_->clearGraphs();
  legend_.clear();
  if (curves.x.empty()) return redraw(*plot_);
  const fuzzy::Variable& depth = model.inputs[x_input];
  for (QCPAxisRect* area : {forces_, pulls_}) {
    styleAxis(*area->axis(QCPAxis::atBottom), depth);
    area->axis(QCPAxis::atBottom)->grid()->setVisible(false);
  }
  forces_->axis(QCPAxis::atBottom)->setTickLabels(false);
  pulls_->axis(QCPAxis::atBottom)->setLabel(axisText(depth));
  const auto numbers = figures::expertNumbers(model.experts);
  drawForces(model, curves, numbers);
  drawPulls(model, curves, numbers);
  redraw(*plot_);
}

void LeaveOneOutPlot::setBand(const ShownBand* band) { band_ = band == nullptr ? std::nullopt : std::optional(*band); }

void LeaveOneOutPlot::drawBand(const figures::ForceCurves& curves) {
  QVector<double> x(curves.x.begin(), curves.x.end());
  QVector<double> low;
  QVector<double> high;
  if (band_) {
    x = QVector<double>(band_->x.begin(), band_->x.end());
    for (const elicitation::BandPoint& point : band_->band.points) {
      low << (point.force_n ? point.low_n : qQNaN());
      high << (point.force_n ? point.high_n : qQNaN());
    }
  }
  for (qsizetype i = 0; !band_ && i < x.size(); ++i) {
    double least = qQNaN();
    double most = qQNaN();
    for (const auto& expert : curves.experts) {
      const fuzzy::Evaluation& one = expert[static_cast<std::size_t>(i)];
      if (!one.fired) continue;
      least = std::isnan(least) ? one.force_n : std::min(least, one.force_n);
      most = std::isnan(most) ? one.force_n : std::max(most, one.force_n);
    }
    low << least;
    high << most;
  }
  QColor fill = theme::mean();
  fill.setAlphaF(0.12F);
  QCPGraph& bottom = addLine(*forces_, Qt::NoPen);
  QCPGraph& top = addLine(*forces_, Qt::NoPen);
  bottom.setData(x, low, true);
  top.setData(x, high, true);
  top.setBrush(theme::onCard(fill));
  top.setChannelFillGraph(&bottom);
  const QString name = band_ ? bandMeaning(band_->kind) : tr("From the lowest to the highest expert");
  legend_.push_back({name, Qt::NoPen, theme::onCard(fill)});
}

void LeaveOneOutPlot::drawExperts(const fuzzy::ForceModel& model, const figures::ForceCurves& curves,
                                  const std::vector<std::size_t>& numbers) {
  const QVector<double> x(curves.x.begin(), curves.x.end());
  for (std::size_t e = 0; e < curves.experts.size(); ++e) {
    const QPen pen = expertPen(numbers[e], numbers.size());
    addLine(*forces_, pen).setData(x, forcesOf(curves.experts[e]), true);
    legend_.push_back({harmless(labelOf(model.experts[e])), pen});
  }
}

// In the place of the experts' own curves, in their colors; people without rules have none.
void LeaveOneOutPlot::drawOwnWords(const fuzzy::ForceModel& model, const std::vector<std::size_t>& numbers) {
  const QVector<double> x(band_->x.begin(), band_->x.end());
  for (const OwnWordCurve& curve : band_->own_words) {
    const auto expert = std::find_if(model.experts.begin(), model.experts.end(),
                                     [&](const fuzzy::Expert& one) { return one.id == curve.participant; });
    QPen pen(theme::mutedInk(), 1, Qt::DotLine);
    if (expert != model.experts.end()) {
      pen = expertPen(numbers[static_cast<std::size_t>(expert - model.experts.begin())], numbers.size());
      pen.setWidthF(1);
    }
    QVector<double> forces;
    for (const auto& force_n : curve.forces_n) forces << force_n.value_or(qQNaN());
    addLine(*forces_, pen).setData(x, forces, true);
    legend_.push_back({tr("Words of %1").arg(harmless(text(curve.participant))), pen});
  }
}

void LeaveOneOutPlot::drawForces(const fuzzy::ForceModel& model, const figures::ForceCurves& curves,
                                 const std::vector<std::size_t>& numbers) {
  const QVector<double> x(curves.x.begin(), curves.x.end());
  QCPAxis* const left = forces_->axis(QCPAxis::atLeft);
  styleAxis(*left, model.output);
  left->setLabel(axisText(model.output));
  drawBand(curves);
  band_ && band_->kind == elicitation::BandKind::kWords ? drawOwnWords(model, numbers)
                                                        : drawExperts(model, curves, numbers);
  const QPen pen(theme::mean(), kMeanPx);
  addLine(*forces_, pen).setData(x, forcesOf(curves.mean), true);
  legend_.push_back({tr("Mean"), pen});
}

void LeaveOneOutPlot::drawPulls(const fuzzy::ForceModel& model, const figures::ForceCurves& curves,
                                const std::vector<std::size_t>& numbers) {
  const QVector<double> x(curves.x.begin(), curves.x.end());
  const auto pulls = pullsOf(curves);
  double widest = 0.1;  // N: small distances are not blown up
  for (const auto& pull : pulls) {
    for (const double one : pull) widest = std::isnan(one) ? widest : std::max(widest, std::abs(one));
  }
  fuzzy::Variable axis = model.output;
  axis.max = std::ceil(widest * 10) / 10;
  axis.min = -axis.max;
  QCPAxis* const left = pulls_->axis(QCPAxis::atLeft);
  styleAxis(*left, axis);
  left->setLabel(tr("From the mean (%1)").arg(text(model.output.unit)));
  // What a hand does not notice around the mean.
  QVector<double> below;
  QVector<double> above;
  for (const fuzzy::Evaluation& one : curves.mean) {
    const double jnd = one.fired ? elicitation::justNoticeableDifference(one.force_n) : qQNaN();
    below << -jnd;
    above << jnd;
  }
  QCPGraph& bottom = addLine(*pulls_, Qt::NoPen);
  QCPGraph& top = addLine(*pulls_, Qt::NoPen);
  bottom.setData(x, below, true);
  top.setData(x, above, true);
  top.setBrush(theme::grid());
  top.setChannelFillGraph(&bottom);
  legend_.push_back({tr("Not noticeable: within one just-noticeable difference"), Qt::NoPen, theme::grid()});
  addLine(*pulls_, QPen(theme::mean(), 1)).setData({curves.x.front(), curves.x.back()}, {0, 0}, true);
  for (std::size_t e = 0; e < pulls.size(); ++e) {
    addLine(*pulls_, expertPen(numbers[e], numbers.size()))
        .setData(x, QVector<double>(pulls[e].begin(), pulls[e].end()), true);
  }
}

void LeaveOneOutPlot::paintPicture(QCPPainter& painter, const QSize& size) { paintPlot(*plot_, painter, size, {}); }

namespace {

const QString kAbsent = QStringLiteral("–");

// With all three digits, so that the points of a column stand below each other.
QString newtons(double force_n) { return forceText(force_n, "N"); }

std::vector<WeightRow> weightRows(const elicitation::BuiltModel* built) {
  std::vector<WeightRow> rows;
  if (built == nullptr) return rows;
  const auto& experts = built->model.experts;
  const auto numbers = figures::expertNumbers(experts);
  for (std::size_t i = 0; i < experts.size(); ++i) {
    rows.push_back({experts[i].id, numbers[i], harmless(labelOf(experts[i])), numberText(experts[i].weight, 3), kAbsent,
                    kAbsent, kAbsent, kAbsent});
    WeightRow& row = rows.back();
    if (i >= built->influences.experts.size()) continue;
    const elicitation::ExpertInfluence& influence = built->influences.experts[i];
    row.rms = newtons(influence.rms_n);
    if (!influence.largest) continue;
    row.largest = newtons(influence.largest->newtons);
    if (influence.most_noticeable) row.noticeable = numberText(influence.most_noticeable->noticeable, 1);
    row.where = brokenAtCommas(text(elicitation::shortPointText(built->model, influence.largest->at)));
  }
  return rows;
}

std::vector<Column<WeightRow>> weightColumns(ExpertsLab& lab) {
  using Row = WeightRow;
  const QString left_out = ExpertsLabView::tr("How far the averaged force moves without this expert.");
  return withRole<Row>({{ExpertsLabView::tr("Expert"),
                         &Row::expert,
                         Qt::AlignLeft,
                         {},
                         {{Qt::DecorationRole, [](const Row& row) { return theme::expert(row.number); }}}},
                        {ExpertsLabView::tr("Weight"),
                         &Row::weight,
                         Qt::AlignRight,
                         ExpertsLabView::tr("Double-click a weight to change it."),
                         {{Qt::EditRole, &Row::weight}},
                         [&lab](const Row& row, const QVariant& typed) {
                           const auto weight = typedNumber(typed.toString());
                           if (!weight || *weight < 0) return false;
                           lab.setWeight(std::string(row.id), *weight);  // the row may be another one then
                           return true;
                         }},
                        {ExpertsLabView::tr("Left out, rms"), &Row::rms, Qt::AlignRight, left_out},
                        {ExpertsLabView::tr("At most"), &Row::largest, Qt::AlignRight, left_out},
                        {ExpertsLabView::tr("JND"), &Row::noticeable, Qt::AlignRight,
                         ExpertsLabView::tr("The largest change in just-noticeable differences.")},
                        {ExpertsLabView::tr("Where"), &Row::where, Qt::AlignLeft, left_out}},
                       Qt::ToolTipRole);
}

}  // namespace

// The numbers of the pull plot: the averaged force and everybody's distance from it.

class ExpertsLab;

/// A model must be built.
PlotTable pullTable(const ExpertsLab& lab);

namespace {

struct PullTable {
  Q_DECLARE_TR_FUNCTIONS(PullTable)
};

// Enough to compute the plot again.
QString settingOf(const ExpertsLab& lab) {
  QStringList parts;
  const auto& inputs = lab.built()->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (i == lab.xInput()) continue;
    parts << labelOf(inputs[i]) + QLatin1Char(' ') + exactText(lab.values()[i], inputs[i].unit);
  }
  return parts.join(QStringLiteral(" · "));
}

}  // namespace

PlotTable pullTable(const ExpertsLab& lab) {
  const fuzzy::ForceModel& model = lab.built()->model;
  PlotTable table = labTable(lab.data(), PullTable::tr("averaged force and the experts' distances from it"),
                             QStringLiteral("-pulls"), {settingOf(lab)});
  table.columns = {columnName(model.inputs[lab.xInput()]), columnName(model.output)};
  for (const fuzzy::Expert& expert : model.experts) {
    table.columns.push_back(columnName("from_mean_" + expert.id, model.output.unit));
  }
  const auto pulls = pullsOf(lab.curves());
  for (std::size_t i = 0; i < lab.curves().x.size(); ++i) {
    auto& row = table.rows.emplace_back();
    row.push_back(lab.curves().x[i]);
    row.push_back(forceCell(lab.curves().mean[i]));
    for (const auto& pull : pulls) row.push_back(std::isnan(pull[i]) ? PlotTable::Cell() : PlotTable::Cell(pull[i]));
  }
  return table;
}

namespace {

using elicitation::WeightPolicy;

constexpr WeightPolicy kPolicies[] = {WeightPolicy::kEqual, WeightPolicy::kYears, WeightPolicy::kCategory,
                                      WeightPolicy::kColumn, WeightPolicy::kTable};
constexpr elicitation::BandKind kBands[] = {elicitation::BandKind::kAgain, elicitation::BandKind::kOthers,
                                            elicitation::BandKind::kNext, elicitation::BandKind::kWords};

}  // namespace

ExpertsLabView::ExpertsLabView(ExpertsLab& lab, QWidget* parent)
    : LabView(
          QStringLiteral("experts"), tr("Experts"), [&lab](bool wanted) { lab.setWanted(wanted); }, parent),
      lab_(lab),
      weights_(new Columns<WeightRow>(weightColumns(lab), this)),
      policies_(new Columns<PolicyRow>(policyColumns(), this)),
      pairs_(new Columns<DistanceRow>(this)),
      plot_(new LeaveOneOutPlot),
      policy_(new QComboBox),
      open_(new PrimaryButton(tr("&Open in the bench"))),
      failure_(new QLabel),
      band_(new QComboBox),
      band_text_(new WrappedLabel),
      settings_(new QWidget) {
  auto* both = makeSplit(Qt::Horizontal, {{makeLeft(), 9}, {makeRight(), 10}});
  failure_->setWordWrap(true);
  failure_->setTextFormat(Qt::PlainText);
  setInk(*failure_, theme::errorInk());
  failure_->hide();
  makeColumn(this, {failure_, {both, 1}});

  connect(policy_, &QComboBox::activated, this,
          [this](int index) { lab_.setPolicy(kPolicies[static_cast<std::size_t>(index)]); });
  auto* refresh = new Refresh(this, [this] { refreshState(); });
  connect(&lab_, &ExpertsLab::changed, refresh, &Refresh::request);
  connect(band_, &QComboBox::activated, this, [this](int index) {
    lab_.bands().choose(index == 0 ? std::nullopt : std::optional(kBands[static_cast<std::size_t>(index - 1)]));
  });
  connect(&lab_.bands(), &BandLab::changed, this, &ExpertsLabView::followBand);
  auto* redraws = new Refresh(plot_, [this] { followCurves(); });
  connect(&lab_, &ExpertsLab::curvesChanged, redraws, &Refresh::request);
  connect(&lab_.bands(), &BandLab::changed, redraws, &Refresh::request);
}

QWidget* ExpertsLabView::makeLeft() {
  for (const WeightPolicy policy : kPolicies) policy_->addItem(policyName(policy));
  policy_->setAccessibleName(tr("Weights of the experts"));
  QTableView* const experts =
      makeLabTable(*weights_, -1, tr("Weights and what leaving one expert out changes"), nullptr);
  readWhole(*experts);
  auto* weights = new LabCard(tr("Weights, and leaving one expert out"), experts, tr("Weights"));
  weights->addTool(policy_);
  weights->addTool(new StatisticHelp({Statistic::kRms, Statistic::kNoticeable}));
  auto* details = makeTabs();
  auto* policies = makeLabTable(*policies_, -1, tr("Weight policies beside equal weights"), nullptr);
  policies->setObjectName(QStringLiteral("policies"));
  auto* pairs = makeLabTable(*pairs_, -1, tr("Distances between experts"), nullptr);
  pairs->setObjectName(QStringLiteral("pairs"));
  pairs->verticalHeader()->show();
  pairs->verticalHeader()->setFont(theme::smallFont());
  pairs->horizontalHeader()->setStretchLastSection(false);
  details->addTab(policies, tr("Weights"));
  details->addTab(pairs, tr("Between experts"));
  details->addTab(new WordsAndRulesView(lab_), tr("Words and rules"));
  auto* below = new Card;
  makeColumn(below, {details}, theme::kGrid, inset(theme::kGrid, theme::kGrid / 2));
  return makeSplit(Qt::Vertical, {weights, below});
}

QWidget* ExpertsLabView::makeRight() {
  auto* page = new QWidget;
  makeColumn(settings_, {}, theme::kGrid / 2, inset(theme::kGrid, 0));
  band_->setObjectName(QStringLiteral("band"));
  band_->setAccessibleName(tr("Band around the averaged force"));
  band_->setToolTip(tr("Choose the band that says how far the averaged force can be trusted."));
  band_->addItem(tr("Band: the experts"));
  for (const elicitation::BandKind kind : kBands) {
    band_->addItem(tr("Band: %1").arg(bandName(kind)));
    band_->setItemData(band_->count() - 1, bandMeaning(kind), Qt::ToolTipRole);
  }
  setMuted(*band_text_);
  band_text_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  band_text_->setMinimumHeight(3 * QFontMetrics(band_text_->font()).lineSpacing());
  band_text_->hide();
  makeColumn(page, {{plot_, 1}, band_text_, settings_});
  open_->setToolTip(tr("Add the averaged model to the study as another model, and go on to tuning."));
  connect(open_, &QPushButton::clicked, this, &ExpertsLabView::benchAsked);
  auto* card = new LabCard(tr("Who pulls where"), page, tr("Pulls"));
  card->addTool(new PlotMenu(
      *plot_, [this] { return pullTable(lab_); }, card));
  card->addTool(band_);
  card->addTool(new StatisticHelp({Statistic::kInterval, Statistic::kNoticeable}));
  card->addTool(open_);
  return card;
}

// The model has its inputs only once it is built.
void ExpertsLabView::makeSettings() {
  if (!rows_.empty() || lab_.built() == nullptr) return;
  const auto& inputs = lab_.built()->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (i == lab_.xInput()) continue;
    const double span = inputs[i].max - inputs[i].min;
    auto* row = new SettingRow(shortLabelOf(inputs[i]), tr("The curves are drawn at this value."),
                               {inputs[i].min, inputs[i].max, span / 100, unitText(inputs[i].unit)}, settings_);
    row->setValue(lab_.values()[i]);
    settings_->layout()->addWidget(row);
    connect(row, &SettingRow::changed, this, [this, i](double value) { lab_.setValue(i, value); });
    connect(&lab_, &ExpertsLab::valueChanged, row, [this, i, row](std::size_t input) {
      if (input == i) row->setValue(lab_.values()[i]);
    });
    rows_.emplace_back(i, row);
  }
}

void ExpertsLabView::refreshState() {
  makeSettings();
  weights_->updateRows(weightRows(lab_.built().get()));
  policies_->setRows(policyRows(lab_.compared()));
  if (std::exchange(of_, lab_.built()) != lab_.built()) showDistances(*pairs_, lab_.built().get());
  open_->setEnabled(lab_.built() != nullptr);
  failure_->setText(lab_.failure());
  failure_->setVisible(!lab_.failure().isEmpty());
  // What the data do not allow cannot be chosen, and says why.
  auto* const choices = qobject_cast<QStandardItemModel*>(policy_->model());
  for (const ComparedWeights& one : lab_.compared()) {
    const auto* const found = std::find(std::begin(kPolicies), std::end(kPolicies), one.policy);
    if (found == std::end(kPolicies)) continue;
    QStandardItem* const item = choices->item(static_cast<int>(found - std::begin(kPolicies)));
    item->setEnabled(one.unavailable.isEmpty());
    item->setToolTip(one.unavailable);
  }
  const auto* const chosen = std::find(std::begin(kPolicies), std::end(kPolicies), lab_.weights().policy);
  policy_->setCurrentIndex(static_cast<int>(chosen - std::begin(kPolicies)));
}

void ExpertsLabView::followBand() {
  const ShownBand* const shown = lab_.bands().shown();
  const QString text = shown != nullptr ? bandText(*shown) : lab_.bands().failure();
  band_text_->setText(text);
  band_text_->setVisible(!text.isEmpty());
  plot_->setBand(shown);
}

void ExpertsLabView::followCurves() {
  if (lab_.built() == nullptr || lab_.curves().experts.size() != lab_.built()->model.experts.size()) {
    plot_->clear();
    return;
  }
  plot_->setCurves(lab_.built()->model, lab_.xInput(), lab_.curves());
}

}  // namespace tactus::workbench
