#include "app/workbench/labs/experts/experts_lab_view.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QSplitter>
#include <QStandardItemModel>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>
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
#include "app/workbench/labs/experts/band_lab.h"
#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/experts/pull_plot.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/plot/plot_menu.h"

namespace tactus::workbench {
namespace {

const QString kAbsent = QStringLiteral("–");
constexpr int kForceDigits = 3;

QString newtons(double force_n) { return quantityText(force_n, "N", kForceDigits); }

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
    row.where = text(elicitation::pointText(built->model, influence.largest->at));
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
                                            elicitation::BandKind::kNext};

}  // namespace

ExpertsLabView::ExpertsLabView(ExpertsLab& lab, QWidget* parent)
    : LabView(
          QStringLiteral("experts"), tr("Experts"), [&lab](bool wanted) { lab.setWanted(wanted); }, parent),
      lab_(lab),
      weights_(new Columns<WeightRow>(weightColumns(lab), this)),
      policies_(new Columns<PolicyRow>(policyColumns(), this)),
      pairs_(new Columns<DistanceRow>(this)),
      plot_(new PullPlot),
      policy_(new QComboBox),
      open_(new PrimaryButton(tr("&Open in the bench"))),
      failure_(new QLabel),
      band_(new QComboBox),
      band_text_(new WrappedLabel),
      settings_(new QWidget) {
  auto* both = new QSplitter(Qt::Horizontal);
  both->setChildrenCollapsible(false);
  both->setHandleWidth(theme::kGrid);
  both->addWidget(makeLeft());
  both->addWidget(makeRight());
  both->setStretchFactor(0, 9);
  both->setStretchFactor(1, 10);
  failure_->setWordWrap(true);
  failure_->setTextFormat(Qt::PlainText);
  setInk(*failure_, theme::errorInk());
  failure_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(failure_);
  layout->addWidget(both, 1);

  connect(policy_, &QComboBox::activated, this,
          [this](int index) { lab_.setPolicy(kPolicies[static_cast<std::size_t>(index)]); });
  auto* refresh = new Refresh(this, [this] { follow(); });
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
  auto* weights =
      new LabCard(tr("Weights, and leaving one expert out"),
                  makeLabTable(*weights_, -1, tr("Weights and what leaving one expert out changes"), nullptr));
  weights->addTool(policy_);
  weights->addTool(new StatisticHelp({Statistic::kRms, Statistic::kNoticeable}));
  auto* details = new QTabWidget;
  new TabLook(*details->tabBar());
  details->setDocumentMode(true);
  auto* policies = makeLabTable(*policies_, -1, tr("Weight policies beside equal weights"), nullptr);
  policies->setObjectName(QStringLiteral("policies"));
  auto* pairs = makeLabTable(*pairs_, -1, tr("Distances between experts"), nullptr);
  pairs->setObjectName(QStringLiteral("pairs"));
  pairs->verticalHeader()->show();
  pairs->verticalHeader()->setFont(theme::smallFont());
  pairs->horizontalHeader()->setStretchLastSection(false);
  details->addTab(policies, tr("Choice of weights"));
  details->addTab(pairs, tr("Between experts"));
  auto* below = new Card;
  auto* inside = new QVBoxLayout(below);
  inside->setContentsMargins(theme::kGrid, theme::kGrid / 2, theme::kGrid, theme::kGrid / 2);
  inside->addWidget(details);
  auto* column = new QSplitter(Qt::Vertical);
  column->setChildrenCollapsible(false);
  column->setHandleWidth(theme::kGrid);
  column->addWidget(weights);
  column->addWidget(below);
  return column;
}

QWidget* ExpertsLabView::makeRight() {
  auto* page = new QWidget;
  auto* rows = new QVBoxLayout(settings_);
  rows->setContentsMargins(theme::kGrid, 0, theme::kGrid, 0);
  rows->setSpacing(theme::kGrid / 2);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(theme::kGrid);
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
  column->addWidget(plot_, 1);
  column->addWidget(band_text_);
  column->addWidget(settings_);
  open_->setToolTip(tr("Add the averaged model to the study as another model, and go on to tuning."));
  connect(open_, &QPushButton::clicked, this, &ExpertsLabView::benchAsked);
  auto* card = new LabCard(tr("Who pulls where"), page);
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
    rows_.emplace_back(i, row);
  }
}

void ExpertsLabView::follow() {
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
