#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTableView>
#include <algorithm>
#include <vector>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/plan/plan_lab.h"
#include "app/workbench/plot/chart.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {
namespace {

constexpr double kLinePx = 2.2;
constexpr double kPlanDotPx = 5;
constexpr double kPlanMarkPx = 13;
constexpr float kBandFill = 0.14F;
constexpr int kPlanSettingsWidth = 40 * theme::kGrid;
constexpr int kPlotShare = 420;
constexpr int kTableShare = 260;

struct PlanChart {
  Q_DECLARE_TR_FUNCTIONS(PlanChart)
};

/// The error over the number of nurses, a line for each number of questions.
Chart planChart(const planning::PlannedStudy& planned) {
  const auto& designs = planned.plan.designs;
  const auto& settings = planned.settings;
  double top_n = settings.precision_n;
  for (const auto& one : designs) top_n = std::max(top_n, one.high_n);
  Chart chart;
  chart.x.label = PlanChart::tr("Nurses");
  chart.x.universe.min = settings.least_nurses;
  chart.x.universe.max = settings.most_nurses;
  chart.x.range = {settings.least_nurses - 0.4, settings.most_nurses + 0.4};
  chart.x.step = settings.most_nurses > 20 ? 5 : 1;
  chart.y.label = PlanChart::tr("Error of the averaged force (N)");
  chart.y.universe.max = 1.05 * top_n;
  chart.y.round_ticks = true;

  const int strokes = planned.now ? planned.now->strokes : settings.strokes.front();
  for (std::size_t k = 0; k < settings.questions.size(); ++k) {
    const QColor color = expertPen(k, settings.questions.size()).color();
    QColor fill = color;
    fill.setAlphaF(kBandFill);
    ChartBand range{{}, {}, {}, fill};
    ChartLine line{{}, {}, QPen(color, kLinePx), {ChartDots::Shape::kDisc, kPlanDotPx, QPen(color)}};
    for (const auto& one : designs) {
      if (one.design.questions != settings.questions[k] || one.design.strokes != strokes) continue;
      range.x << one.design.nurses;
      range.low << one.low_n;
      range.high << one.high_n;
      line.y << one.error_n;
    }
    line.x = range.x;
    chart.parts.emplace_back(range);
    chart.parts.emplace_back(line);
    chart.legend.push_back({PlanChart::tr("%n question(s)", nullptr, settings.questions[k]), line.pen});
  }

  const QPen wanted(theme::accent(), 1.4, Qt::DashLine);
  chart.parts.emplace_back(ChartRule{Qt::Horizontal, settings.precision_n, wanted});
  const QString name = PlanChart::tr("Wanted: ± %1").arg(quantityText(settings.precision_n, "N", 3));
  chart.legend.push_back({name, wanted});
  const auto say = [&chart](const QString& words, const QColor& ink, const QPointF& at, Qt::Alignment side, int away) {
    chart.parts.emplace_back(ChartText{words, at, side, ink, QMargins(0, away, 0, away)});
  };
  say(name, theme::accent(), {chart.x.range->second, settings.precision_n}, Qt::AlignRight | Qt::AlignBottom, 1);
  const auto mark = [&](const planning::DesignError& one, const QString& words, ChartDots::Shape shape,
                        Qt::Alignment side) {
    const ChartDots ring{shape, kPlanMarkPx, QPen(theme::ink(), 2)};
    const QPointF at(one.design.nurses, one.error_n);
    chart.parts.emplace_back(ChartLine{{at.x()}, {at.y()}, Qt::NoPen, ring});
    say(words, theme::ink(), at, side | Qt::AlignHCenter, theme::kGrid);
  };
  if (planned.plan.cheapest) {
    mark(designs[*planned.plan.cheapest], PlanChart::tr("The cheapest"), ChartDots::Shape::kCircle, Qt::AlignBottom);
  }
  const auto* const now = planned.now ? planned.plan.find(*planned.now) : nullptr;
  if (now != nullptr) mark(*now, PlanChart::tr("Now"), ChartDots::Shape::kSquare, Qt::AlignTop);
  return chart;
}

/// The names of the lines in their colors.
class LineNames : public QWidget {
 public:
  LineNames() : row_(makeRow(this, {spring(1)}, 2 * theme::kGrid)) {}

  void setLines(const std::vector<LegendEntry>& lines) {
    for (QLabel* const name : findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly)) delete name;
    for (const LegendEntry& line : lines) {
      if (line.pen.style() != Qt::SolidLine) continue;  // the wanted error is named beside its line
      auto* const label = new QLabel(line.name, this);
      label->setFont(theme::smallFont());
      setInk(*label, line.pen.color());
      row_->insertWidget(row_->count() - 1, label);
    }
  }

 private:
  QHBoxLayout* row_;
};

PlotTable planTable(const PlanLab& lab) {
  PlotTable table = labTable(lab.data(), PlanChart::tr("error of the averaged force by nurses and questions"),
                             QStringLiteral("-plan"), {text(std::string(planning::kSimulatedNurses))});
  table.columns = {"questions", "nurses", "strokes", "error_n", "low_n", "high_n", "p95_n", "bias_n", "hours"};
  for (const auto& one : lab.plan() == nullptr ? std::vector<planning::DesignError>() : lab.plan()->plan.designs) {
    const auto& design = one.design;
    table.rows.push_back({double(design.questions), double(design.nurses), double(design.strokes), one.error_n,
                          one.low_n, one.high_n, one.p95_n, one.bias_n, one.hours});
  }
  return table;
}

class PlanView : public LabView {
  Q_DECLARE_TR_FUNCTIONS(PlanView)

 public:
  explicit PlanView(PlanLab& lab)
      : LabView(
            QStringLiteral("plan"), tr("Plan"), [&lab](bool wanted) { lab.setWanted(wanted); }, nullptr),
        lab_(lab),
        rows_(new Columns<PlanRow>(planColumns(), this)),
        region_(new QComboBox),
        says_(new QLabel),
        assumed_(new QLabel),
        plot_(new ChartView),
        names_(new LineNames) {
    makeRow(this, {makeSettings(), {makeResults(), 1}});
    auto* const refresh = new Refresh(this, [this] { showPlan(); });
    connect(&lab_, &PlanLab::changed, refresh, &Refresh::request);
    connect(&lab_, &PlanLab::regionsChanged, this, [this] { fillRegions(); });
    fillRegions();
    showPlan();
  }

 private:
  QWidget* makeSettings() {
    auto* const precision = new SettingRow(
        tr("Wanted error"), tr("How near the averaged force shall come to the mean force of other nurses."),
        {0.02, 0.5, 0.01, QStringLiteral("N")});
    precision->setValue(lab_.precisionN());
    auto* const nurses =
        new SettingRow(tr("Nurses, at most"), tr("Up to how many nurses designs are tried."), {2, 40, 1, {}, true});
    nurses->setValue(lab_.wish().most_nurses);
    auto* const studies = new SettingRow(
        tr("Simulated studies"), tr("Of each design: more of them make its error surer."), {50, 2000, 50, {}, true});
    studies->setValue(lab_.wish().studies);
    region_->setAccessibleName(tr("Where the error counts"));
    region_->setToolTip(tr("Choose where the error counts: in all regions, or in one."));
    for (QLabel* const words : {says_, assumed_}) {
      words->setWordWrap(true);
      words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    says_->setObjectName(QStringLiteral("says"));
    setMuted(*assumed_);
    auto* const page = new QWidget;
    auto* const where = new QLabel(tr("W&here"));
    where->setBuddy(region_);
    makeColumn(page, {precision, makeRow({where, {region_, 1}}), nurses, studies, says_, assumed_, spring(1)},
               2 * theme::kGrid, {0, theme::kGrid / 2, theme::kGrid, 0});
    auto* const scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setAccessibleName(tr("What is planned"));
    scroll->setWidget(page);
    for (QWidget* part : {page, scroll->viewport()}) part->setAutoFillBackground(false);
    auto* const card = new LabCard(tr("Nurses and questions"), scroll);
    keepFitted(*card, [card] { card->setFixedWidth(appearance::scaled(kPlanSettingsWidth)); });
    connect(precision, &SettingRow::changed, this, [this](double value) { lab_.setPrecisionN(value); });
    connect(nurses, &SettingRow::changed, this, [this](double value) {
      PlanWish wish = lab_.wish();
      wish.most_nurses = static_cast<int>(value);
      lab_.setWish(wish);
    });
    connect(studies, &SettingRow::changed, this, [this](double value) {
      PlanWish wish = lab_.wish();
      wish.studies = static_cast<int>(value);
      lab_.setWish(wish);
    });
    connect(region_, &QComboBox::activated, this, [this](int) {
      PlanWish wish = lab_.wish();
      wish.region = region_->currentData().toString().toStdString();
      lab_.setWish(wish);
    });
    return card;
  }

  QWidget* makeResults() {
    auto* const table = makeLabTable(*rows_, rows_->columnCount() - 1, tr("Designs and their errors"), nullptr);
    plot_->setMinimumSize(320, 180);
    plot_->setAccessibleName(tr("Error of the averaged force over the number of nurses"));
    auto* const page = new QWidget;
    makeColumn(page, {names_, {plot_, 1}}, theme::kGrid / 2, inset(theme::kGrid / 2));
    auto* const curves = new LabCard(tr("Error by the number of nurses"), page);
    curves->addTool(new PlotMenu(
        *plot_, [this] { return planTable(lab_); }, curves));
    auto* const designs = new LabCard(tr("Every design"), table);
    auto* const split = makeSplit(Qt::Vertical, {{curves, 3}, {designs, 2}});
    split->setSizes({kPlotShare, kTableShare});
    return split;
  }

  void fillRegions() {
    const QSignalBlocker quiet(region_);
    region_->clear();
    region_->addItem(tr("In all regions"), QString());
    for (const auto& term : lab_.regions()) region_->addItem(labelOf(term), QString::fromStdString(term.id));
  }

  void showPlan() {
    const auto* const planned = lab_.plan();
    planned == nullptr ? plot_->clear() : plot_->setChart(planChart(*planned));
    names_->setLines(plot_->legend());
    rows_->updateRows(planned == nullptr ? std::vector<PlanRow>() : planRows(*planned));
    QStringList says;
    if (planned == nullptr) {
      says << (lab_.failure().isEmpty() ? tr("Simulating studies…") : lab_.failure());
    } else {
      says << spelled(planning::cheapestSentence(*planned));
      if (planned->now) {
        says << tr("The study now: %1.").arg(spelled(planning::designText(planned->questions, *planned->now)));
        for (const auto& gain : planning::gainsOf(*planned)) says << spelled(planning::sentence(gain));
      }
    }
    QStringList assumed;
    if (planned != nullptr) {
      assumed << spelled(planning::kSimulatedNurses);
      for (const auto& note : planned->notes) assumed << spelled(note);
    }
    says_->setText(says.join(QLatin1Char('\n')));
    assumed_->setText(assumed.join(QLatin1Char('\n')));
  }

  PlanLab& lab_;
  Columns<PlanRow>* rows_;
  QComboBox* region_;
  QLabel* says_;
  QLabel* assumed_;  ///< about the simulated nurses
  ChartView* plot_;
  LineNames* names_;
};

}  // namespace

QWidget* makePlanView(PlanLab& lab) { return new PlanView(lab); }

}  // namespace tactus::workbench
