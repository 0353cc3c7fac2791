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

/// The error over the number of nurses, a line for each number of questions.
class PlanPlot : public QWidget, public PlotSource {
  Q_DECLARE_TR_FUNCTIONS(PlanPlot)

 public:
  PlanPlot() : plot_(makePlot(this)), names_(makeRow({spring(1)}, 2 * theme::kGrid)) {
    makeColumn(this, {names_, {plot_, 1}}, theme::kGrid / 2, inset(theme::kGrid / 2));
    plot_->axisRect()->setMinimumMargins(QMargins(0, theme::kGrid, 2 * theme::kGrid, 0));
    setMinimumSize(320, 180);
    setAccessibleName(tr("Error of the averaged force over the number of nurses"));
  }

  void show(const planning::PlannedStudy* planned) {
    plot_->clearPlottables();
    plot_->clearItems();
    legend_.clear();
    for (QLabel* const name : findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly)) delete name;
    plot_->setVisible(planned != nullptr);
    if (planned == nullptr) return;
    const auto& designs = planned->plan.designs;
    double top_n = planned->settings.precision_n;
    for (const auto& one : designs) top_n = std::max(top_n, one.high_n);
    setAxes(*planned, 1.05 * top_n);
    const auto& questions = planned->settings.questions;
    const int strokes = planned->now ? planned->now->strokes : planned->settings.strokes.front();
    for (std::size_t k = 0; k < questions.size(); ++k) {
      std::vector<planning::DesignError> line;
      std::copy_if(designs.begin(), designs.end(), std::back_inserter(line), [&](const auto& one) {
        return one.design.questions == questions[k] && one.design.strokes == strokes;
      });
      addLine(line, questions[k], expertPen(k, questions.size()).color());
    }
    addPrecision(*planned);
    if (planned->plan.cheapest) addMark(designs[*planned->plan.cheapest], tr("The cheapest"), true);
    const auto* const now = planned->now ? planned->plan.find(*planned->now) : nullptr;
    if (now != nullptr) addMark(*now, tr("Now"), false);
    redraw(*plot_);
  }

  std::vector<LegendEntry> legend() const override { return legend_; }
  void paintPicture(QCPPainter& painter, const QSize& size) override { paintPlot(*plot_, painter, size, {}); }

 private:
  void setAxes(const planning::PlannedStudy& planned, double top_n) {
    fuzzy::Variable nurses;
    nurses.min = planned.settings.least_nurses;
    nurses.max = planned.settings.most_nurses;
    styleAxis(*plot_->xAxis, nurses);
    plot_->xAxis->setRange(nurses.min - 0.4, nurses.max + 0.4);
    plot_->xAxis->setLabel(tr("Nurses"));
    auto whole = QSharedPointer<QCPAxisTickerFixed>::create();
    whole->setTickStep(planned.settings.most_nurses > 20 ? 5 : 1);
    plot_->xAxis->setTicker(whole);
    fuzzy::Variable error;
    error.unit = "N";
    error.max = top_n;
    styleAxis(*plot_->yAxis, error);
    plot_->yAxis->setTicker(QSharedPointer<QCPAxisTicker>::create());
    plot_->yAxis->setLabel(tr("Error of the averaged force (N)"));
    for (QCPAxis* const axis : {plot_->xAxis, plot_->yAxis}) axis->setSubTicks(false);
  }

  void addLine(const std::vector<planning::DesignError>& line, int questions, const QColor& color) {
    QVector<double> nurses, low, error, high;
    for (const auto& one : line) {
      nurses << one.design.nurses;
      low << one.low_n;
      error << one.error_n;
      high << one.high_n;
    }
    QCPGraph* const bottom = plot_->addGraph();
    QCPGraph* const top = plot_->addGraph();
    for (QCPGraph* const edge : {bottom, top}) edge->setPen(Qt::NoPen);
    bottom->setData(nurses, low, true);
    top->setData(nurses, high, true);
    QColor fill = color;
    fill.setAlphaF(kBandFill);
    top->setBrush(fill);
    top->setChannelFillGraph(bottom);
    QCPGraph* const graph = plot_->addGraph();
    graph->setPen(QPen(color, kLinePx));
    graph->setScatterStyle({QCPScatterStyle::ssDisc, color, color, kPlanDotPx});
    graph->setData(nurses, error, true);
    const QString name = tr("%n question(s)", nullptr, questions);
    legend_.push_back({name, QPen(color, kLinePx)});
    auto* const label = new QLabel(name, this);
    label->setFont(theme::smallFont());
    setInk(*label, color);
    names_->insertWidget(names_->count() - 1, label);
  }

  void addPrecision(const planning::PlannedStudy& planned) {
    auto* const line = new QCPItemStraightLine(plot_);
    line->setPen(QPen(theme::accent(), 1.4, Qt::DashLine));
    line->point1->setCoords(0, planned.settings.precision_n);
    line->point2->setCoords(1, planned.settings.precision_n);
    const QString name = tr("Wanted: ± %1").arg(quantityText(planned.settings.precision_n, "N", 3));
    legend_.push_back({name, line->pen(), Qt::NoBrush});
    addText(name, theme::accent(), plot_->xAxis->range().upper, planned.settings.precision_n,
            Qt::AlignRight | Qt::AlignBottom);
  }

  void addMark(const planning::DesignError& one, const QString& name, bool cheapest) {
    QCPGraph* const graph = plot_->addGraph();
    const QColor ink = theme::ink();
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setScatterStyle(
        {cheapest ? QCPScatterStyle::ssCircle : QCPScatterStyle::ssSquare, QPen(ink, 2), Qt::NoBrush, kPlanMarkPx});
    graph->setData({double(one.design.nurses)}, {one.error_n});
    addText(name, ink, one.design.nurses, one.error_n, (cheapest ? Qt::AlignBottom : Qt::AlignTop) | Qt::AlignHCenter,
            theme::kGrid);
  }

  void addText(const QString& words, const QColor& ink, double x, double y, Qt::Alignment side, int away = 1) {
    auto* const label = new QCPItemText(plot_);
    label->setText(words);
    label->setFont(theme::smallFont());
    label->setColor(ink);
    label->setPositionAlignment(side);
    label->position->setCoords(x, y);
    label->setPadding(QMargins(0, away, 0, away));
  }

  QCustomPlot* plot_;
  QHBoxLayout* names_;  ///< what the colors are
  std::vector<LegendEntry> legend_;
};

PlotTable planTable(const PlanLab& lab) {
  PlotTable table = labTable(lab.data(), PlanPlot::tr("error of the averaged force by nurses and questions"),
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
        plot_(new PlanPlot) {
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
    auto* const curves = new LabCard(tr("Error by the number of nurses"), plot_);
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
    plot_->show(planned);
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
  PlanPlot* plot_;
};

}  // namespace

QWidget* makePlanView(PlanLab& lab) { return new PlanView(lab); }

}  // namespace tactus::workbench
