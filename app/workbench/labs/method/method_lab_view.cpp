#include "app/workbench/labs/method/method_lab_view.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QProgressBar>
#include <QTableView>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/quiet_table.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/method/method_lab.h"
#include "app/workbench/plot/chart.h"
#include "app/workbench/plot/plot_menu.h"
#include "elicitation/force/noticeable_force.h"
#include "elicitation/model/method_study.h"

namespace tactus::workbench {
namespace {

constexpr double kNowPx = 3;
constexpr double kOtherPx = 2.2;

struct MethodChart {
  Q_DECLARE_TR_FUNCTIONS(MethodChart)
};

/// The averaged force over the depth as it is and with another choice of the method, with what a hand does not notice.
/// `other`: the name of the other curve. `marked`: the place of the largest difference has a line.
Chart methodChart(const fuzzy::ForceModel& model, const MethodCurves& curves, const QString& other, bool marked) {
  const fuzzy::Variable& depth = model.inputs[curves.x_input];
  Chart chart{{.universe = depth, .label = axisText(depth), .grid = false},
              {.universe = model.output, .label = axisText(model.output)}};
  ChartBand unnoticed{QVector<double>(curves.now.x.begin(), curves.now.x.end()), {}, {}, theme::grid()};
  for (const fuzzy::Evaluation& one : curves.now.mean) {
    const double jnd = one.fired ? elicitation::justNoticeableDifference(one.force_n) : qQNaN();
    unnoticed.low << one.force_n - jnd;
    unnoticed.high << one.force_n + jnd;
  }
  chart.parts.emplace_back(unnoticed);
  if (marked) {
    const QPen pen(theme::accent(), 1, Qt::DashLine);
    chart.parts.emplace_back(ChartRule{Qt::Vertical, curves.at[curves.x_input], pen});
    chart.legend.push_back({MethodChart::tr("Where they differ most"), pen});
  }
  const auto add = [&chart](const auto& curve, const QString& name, const QPen& pen) {
    ChartLine line{QVector<double>(curve.x.begin(), curve.x.end()), {}, pen};
    for (const fuzzy::Evaluation& one : curve.mean) line.y << (one.fired ? one.force_n : qQNaN());
    chart.parts.emplace_back(line);
    chart.legend.push_back({name, pen});
  };
  add(curves.now, MethodChart::tr("As it is"), QPen(theme::mean(), kNowPx));
  add(curves.other, other, QPen(theme::warningInk(), kOtherPx));
  chart.legend.push_back(
      {MethodChart::tr("Not noticeable: within one just-noticeable difference"), Qt::NoPen, theme::grid()});
  return chart;
}

}  // namespace

// The two curves of the method study as numbers, for files and the clipboard.

class MethodLab;

/// Needs the curves of the chosen variant.
PlotTable methodCurvesTable(const MethodLab& lab);

namespace {

struct MethodCurvesTable {
  Q_DECLARE_TR_FUNCTIONS(MethodCurvesTable)
};

}  // namespace

PlotTable methodCurvesTable(const MethodLab& lab) {
  PlotTable table = labTable(lab.data(), MethodCurvesTable::tr("the averaged force with another choice of the method"),
                             QStringLiteral("-method"));
  const MethodCurves* const curves = lab.curves();
  if (curves == nullptr) return table;
  const auto& variant = lab.found()->variants[curves->variant];
  table.caption << QStringLiteral("%1: %2").arg(text(elicitation::factorTitle(variant.factor)), spelled(variant.value));
  table.caption << placeOfCurves(lab.model(), *curves);
  const auto& depth = lab.model().inputs[curves->x_input];
  table.columns = {"curve", columnName(depth), columnName(lab.model().output)};
  const auto add = [&](const std::string& name, const figures::ForceCurves& one) {
    for (std::size_t i = 0; i < one.x.size(); ++i) table.rows.push_back({name, one.x[i], forceCell(one.mean[i])});
  };
  add("as_it_is", curves->now);
  add(variant.factor + " " + variant.value, curves->other);
  return table;
}

namespace {

constexpr int kFactorWidth = 24 * theme::kGrid;  // px; longer names wrap
constexpr int kNowWidth = 11 * theme::kGrid;
constexpr int kValueRow = 22;  // px: three values are seen at once in a window of 720 px
constexpr int kLeftShare = 600;
constexpr int kRightShare = 480;
constexpr int kUpperShare = 500;
constexpr int kLowerShare = 170;

}  // namespace

MethodLabView::MethodLabView(MethodLab& lab, QWidget* parent)
    : LabView(
          QStringLiteral("method"), tr("Method"), [&lab](bool wanted) { lab.setWanted(wanted); }, parent),
      lab_(lab),
      factors_(new Columns<FactorRow>(factorColumns(), this)),
      variants_(new Columns<VariantRow>(variantColumns(), this)),
      plot_(new ChartView),
      button_(new PrimaryButton(tr("&Compare the choices"))),
      progress_(new QProgressBar),
      state_(new WrappedLabel),
      place_(new WrappedLabel) {
  auto* both = makeSplit(Qt::Horizontal, {{makeLeft(), 1}, {makeRight(), 1}});
  both->setSizes({kLeftShare, kRightShare});
  makeColumn(this, {makeHead(), {both, 1}});

  connect(button_, &QPushButton::clicked, this, [this] { lab_.isBusy() ? lab_.cancel() : lab_.compare(); });
  auto* refresh = new Refresh(this, [this] { refreshState(); });
  connect(&lab_, &MethodLab::changed, refresh, &Refresh::request);
  auto* redraws = new Refresh(plot_, [this] { followCurves(); });
  connect(&lab_, &MethodLab::curvesChanged, redraws, &Refresh::request);
  connect(factor_view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &MethodLabView::followFactor);
  connect(variant_view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) {
            if (index.isValid()) lab_.choose(variants_->row(index.row()).index);
          });
  refreshState();
}

QWidget* MethodLabView::makeHead() {
  auto* head = new Card;
  setMuted(*state_);
  state_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  // As high for one sentence as for two: what is below stays where it is while the comparison runs.
  state_->setMinimumHeight(2 * QFontMetrics(state_->font()).lineSpacing());
  state_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
  progress_->setRange(0, 100);
  progress_->setFixedWidth(20 * theme::kGrid);
  progress_->setAccessibleName(tr("How much of the comparison is done"));
  makeRow(head, {button_, progress_, {state_, 1}}, 2 * theme::kGrid, inset(2 * theme::kGrid, theme::kGrid));
  return head;
}

QWidget* MethodLabView::makeLeft() {
  factor_view_ = makeLabTable(*factors_, kVerdictColumn, tr("Choices of the method"), nullptr);
  readWhole(*factor_view_);
  for (const auto& [column, width] : {std::pair(0, kFactorWidth), {1, kNowWidth}}) {
    factor_view_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Interactive);
    factor_view_->setColumnWidth(column, width);
  }
  variant_view_ = makeLabTable(*variants_, variants_->columnCount() - 1, tr("Values of the choice"), nullptr);
  variant_view_->verticalHeader()->setDefaultSectionSize(kValueRow);
  auto* choices = new LabCard(tr("Does the choice matter here?"), factor_view_);
  auto* values = new LabCard(tr("Every value of this choice"), variant_view_);
  values->addTool(new StatisticHelp({Statistic::kRms, Statistic::kNoticeable}));
  auto* column = makeSplit(Qt::Vertical, {{choices, 5}, {values, 2}});
  column->setSizes({kUpperShare, kLowerShare});
  return column;
}

QWidget* MethodLabView::makeRight() {
  auto* page = new QWidget;
  setMuted(*place_);
  place_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  place_->setMinimumHeight(3 * QFontMetrics(place_->font()).lineSpacing());
  plot_->setMinimumSize(320, 220);
  plot_->layout()->setContentsMargins(inset(theme::kGrid / 2));
  plot_->setAccessibleName(tr("Averaged force as it is and with another choice"));
  makeColumn(page, {{plot_, 1}, place_});
  auto* card = new LabCard(tr("Where it moves the force most"), page);
  card->addTool(new PlotMenu(
      *plot_, [this] { return methodCurvesTable(lab_); }, card));
  return card;
}

void MethodLabView::refreshState() {
  const bool busy = lab_.isBusy();
  button_->setText(busy ? tr("Cancel") : tr("&Compare the choices"));
  button_->setEnabled(busy || lab_.isPossible());
  progress_->setVisible(busy);
  progress_->setValue(static_cast<int>(std::lround(100 * lab_.work().progress())));
  const auto* const found = lab_.found();
  if (busy) {
    state_->setText(tr("Building the averaged model with one choice changed at a time…"));
  } else if (!lab_.failure().isEmpty()) {
    state_->setText(lab_.failure());
  } else if (found == nullptr) {
    state_->setText(
        tr("Builds the averaged model again with one choice of the method changed at a time, and compares "
           "the forces. With four participants this takes some seconds."));
  } else if (lab_.isOld()) {
    state_->setText(tr("The study or a setting has changed since: compare again."));
  } else {
    state_->setText(tr("Compared at %1 points spread evenly over the inputs. A choice matters if another value is felt "
                       "at more than %2 % of them. Choose a row to see where.")
                        .arg(found->points)
                        .arg(numberText(100 * elicitation::kMattersShare, 0)));
  }
  if (std::exchange(shown_, lab_.foundNumber()) == lab_.foundNumber()) return;
  factors_->setRows(found == nullptr ? std::vector<FactorRow>() : factorRows(*found));
  variants_->setRows({});
  if (found != nullptr && factors_->rowCount() > 0) factor_view_->selectRow(0);
}

void MethodLabView::followFactor() {
  const QModelIndex index = factor_view_->currentIndex();
  const auto* const found = lab_.found();
  if (!index.isValid() || found == nullptr || shown_ != lab_.foundNumber()) return;
  const auto& factor = found->factors[factors_->row(index.row()).index];
  variants_->setRows(variantRows(*found, factor.factor, lab_.model()));
  if (!factor.worst) return lab_.choose(std::nullopt);
  const auto& rows = variants_->rows();
  const auto worst =
      std::find_if(rows.begin(), rows.end(), [&](const VariantRow& row) { return row.index == *factor.worst; });
  variant_view_->selectRow(worst == rows.end() ? -1 : static_cast<int>(worst - rows.begin()));
}

void MethodLabView::followCurves() {
  const MethodCurves* const curves = lab_.curves();
  if (curves == nullptr) {
    plot_->clear();
    place_->clear();
    return;
  }
  const auto& variant = lab_.found()->variants[curves->variant];
  const QString other =
      QStringLiteral("%1: %2").arg(text(elicitation::factorTitle(variant.factor)), spelled(variant.value));
  const bool marked = !variant.at.empty();
  plot_->setChart(methodChart(lab_.model(), *curves, other, marked));
  const auto& output = lab_.model().output;
  const QString place = placeOfCurves(lab_.model(), *curves);
  place_->setText(marked
                      ? tr("Thick: as it is, with one just-noticeable difference around it. Thin: %1. Drawn at %2; "
                           "the largest difference is %3 at %4.")
                            .arg(other, place, quantityText(variant.largest_n, output.unit, 3),
                                 quantityText(curves->at[curves->x_input], lab_.model().inputs[curves->x_input].unit))
                      : tr("%1 moves the force nowhere. Drawn at %2.").arg(other, place));
}

}  // namespace tactus::workbench
