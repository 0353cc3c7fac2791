// The stroke that tells two models apart: the search with its progress, then the movement, both forces over it and what
// can be done with it.
#include <QCoreApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>
#include <limits>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/tune/tell/tell_controller.h"

namespace tactus::workbench {
namespace {

constexpr int kTellWide = 720;      // px
constexpr int kHigh = 600;          // px
constexpr int kBesideStroke = 56;   // px at 100 %, for the numbers and the name of an axis
constexpr int kBelow = 40;          // px at 100 %, likewise
constexpr int kStrokeHeight = 260;  // px

/// Above the movement, below it the two forces; one axis of time.
class TellPlot : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(TellPlot)

 public:
  explicit TellPlot(QWidget* parent) : QWidget(parent), plot_(makePlot(this)) {
    setAccessibleName(tr("The stroke and both forces over time"));
    setMinimumHeight(kStrokeHeight);
    makeColumn(this, {{plot_, 1}});
    forces_ = new QCPAxisRect(plot_);
    plot_->plotLayout()->addElement(1, 0, forces_);
    plot_->plotLayout()->setRowStretchFactor(1, 1.6);
    plot_->plotLayout()->setRowSpacing(0);
    // The new axes belong to the layer of the others.
    for (QCPAxis* axis : forces_->axes()) {
      axis->setLayer(QStringLiteral("axes"));
      axis->grid()->setLayer(QStringLiteral("grid"));
    }
    plot_->yAxis2->setVisible(true);
    plot_->yAxis2->grid()->setVisible(false);
    plot_->xAxis->setTickLabels(false);
    keepFitted(*this, [this] { takeMargins(); });

    depth_ = plot_->addGraph();
    speed_ = plot_->addGraph(plot_->xAxis, plot_->yAxis2);
    QCPAxis* const time = forces_->axis(QCPAxis::atBottom);
    QCPAxis* const force = forces_->axis(QCPAxis::atLeft);
    upper_ = plot_->addGraph(time, force);
    lower_ = plot_->addGraph(time, force);
    a_ = plot_->addGraph(time, force);
    b_ = plot_->addGraph(time, force);
    for (int i = 0; i < plot_->graphCount(); ++i) plot_->graph(i)->setAdaptiveSampling(false);
    upper_->setChannelFillGraph(lower_);
    for (QCPGraph* edge : {upper_, lower_}) edge->setPen(Qt::NoPen);
    upper_->setBrush(theme::warningFill());
    depth_->setPen(QPen(theme::accent(), 2));
    speed_->setPen(QPen(theme::mutedInk(), 1.4, Qt::DotLine));
    a_->setPen(QPen(theme::mutedInk(), 1.6, Qt::DashLine));
    b_->setPen(QPen(theme::mean(), 2));
  }

  void show(const Told& told, const fuzzy::ForceModel& model) {
    QVector<double> time, depth, speed, a, b, felt_a, felt_b;
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    double most_n = 0;
    for (const ToldMoment& one : told.moments) {
      time << one.at.time_s;
      depth << one.at.depth_mm;
      speed << one.at.speed_mm_s;
      a << (one.a.fired ? one.a.force_n : kNone);
      b << (one.b.fired ? one.b.force_n : kNone);
      felt_a << (one.felt ? one.a.force_n : kNone);
      felt_b << (one.felt ? one.b.force_n : kNone);
      if (one.a.fired) most_n = std::max(most_n, one.a.force_n);
      if (one.b.fired) most_n = std::max(most_n, one.b.force_n);
    }
    const fuzzy::Variable& along = model.inputs[told.inputs.depth];
    const auto axis = [](QCPAxis& of, const QString& label, double low, double high) {
      fuzzy::Variable shown;
      shown.min = low;
      shown.max = high;
      styleAxis(of, shown);
      of.setTicker(QSharedPointer<QCPAxisTicker>::create());
      of.ticker()->setTickCount(4);
      of.setLabel(label);
    };
    constexpr double kAbove = 1.08;  // of the largest value
    const double end_s = told.moments.back().at.time_s;
    axis(*plot_->xAxis, {}, 0, end_s);
    axis(*forces_->axis(QCPAxis::atBottom), tr("Time (s)"), 0, end_s);
    const double margin_mm = (told.found.stroke.to_mm - told.found.stroke.from_mm) * (kAbove - 1);
    axis(*plot_->yAxis, tr("Depth (%1)").arg(text(along.unit)), told.found.stroke.from_mm - margin_mm,
         told.found.stroke.to_mm + margin_mm);
    axis(*plot_->yAxis2, tr("Speed (mm/s)"), 0, told.found.stroke.peak_mm_s * kAbove);
    axis(*forces_->axis(QCPAxis::atLeft), tr("Force (%1)").arg(text(model.output.unit)), 0,
         most_n > 0 ? most_n * kAbove : 1);
    depth_->setData(time, depth, true);
    speed_->setData(time, speed, true);
    a_->setData(time, a, true);
    b_->setData(time, b, true);
    upper_->setData(time, felt_b, true);
    lower_->setData(time, felt_a, true);
    plot_->plotLayout()->update(QCPLayoutElement::upLayout);
    redraw(*plot_);
  }

 private:
  void takeMargins() {
    const int beside = appearance::scaled(kBesideStroke);
    for (QCPAxisRect* area : plot_->axisRects()) {
      area->setAutoMargins(QCP::msNone);
      area->setMargins({beside, theme::kGrid, beside, area == forces_ ? appearance::scaled(kBelow) : theme::kGrid});
    }
  }

  QCustomPlot* plot_;
  QCPAxisRect* forces_ = nullptr;
  QCPGraph* depth_ = nullptr;
  QCPGraph* speed_ = nullptr;
  QCPGraph* upper_ = nullptr;  ///< where it is felt: between this and the next
  QCPGraph* lower_ = nullptr;
  QCPGraph* a_ = nullptr;
  QCPGraph* b_ = nullptr;
};

class TellWindow : public QDialog {
  Q_DECLARE_TR_FUNCTIONS(TellWindow)

 public:
  TellWindow(TellController& tell, QWidget* parent)
      : QDialog(parent),
        tell_(tell),
        names_(label("tell_names")),
        verdict_(label("tell_verdict")),
        bound_(label("tell_bound")),
        details_(label("tell_details")),
        plot_(new TellPlot(this)),
        legend_(new ElidedLabel(this)),
        bar_(new QProgressBar(this)),
        cancel_(button(tr("Cancel"), "tell_cancel")),
        play_(button(tr("Play it"), "tell_play")),
        duel_(button(tr("Use it in the duel…"), "tell_duel")),
        keep_(button(tr("Keep as a stroke"), "tell_keep")),
        again_(button(tr("Search again"), "tell_again")) {
    setWindowTitle(tr("The stroke that tells"));
    setObjectName(QStringLiteral("tell_window"));
    verdict_->setFont(theme::headingFont());
    setMuted(*names_);
    setMuted(*legend_);
    legend_->setFullText(
        tr("above: depth as a line, speed dotted · below: A dashed, B as a line; shaded: felt, one JND or more"),
        tr("A dashed, B as a line; shaded: felt"));
    bar_->setRange(0, 100);
    bar_->setAccessibleName(tr("Progress of the search"));
    play_->setToolTip(
        tr("Let a calculated hand make the stroke in the panel Feel: the force of B, with that of A beside it"));
    duel_->setToolTip(
        tr("Feel A and B blind on this way, at the speed of the largest difference and with these conditions"));
    keep_->setToolTip(
        tr("Keep it in the study, marked as calculated: the panel Strokes runs it through the model after each edit. "
           "Without a study it becomes a file"));
    auto* const close = button(tr("Close"), "tell_close");
    auto* const help = new StatisticHelp({Statistic::kNoticeable, Statistic::kRms}, this);
    makeColumn(this,
               {names_,
                makeRow({{verdict_, 1}, {help, 0, Qt::AlignTop}}),
                bound_,
                details_,
                {plot_, 100},
                legend_,
                spring(1),
                makeRow({{bar_, 1}, cancel_}),
                makeRow({play_, duel_, keep_, spring(1), again_, close})},
               theme::kGrid, inset(2 * theme::kGrid));
    resize(kTellWide, kHigh);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(cancel_, &QPushButton::clicked, &tell_, &TellController::cancel);
    connect(again_, &QPushButton::clicked, &tell_, &TellController::begin);
    connect(play_, &QPushButton::clicked, &tell_, &TellController::playAsked);
    connect(duel_, &QPushButton::clicked, &tell_, &TellController::duelAsked);
    connect(keep_, &QPushButton::clicked, &tell_, &TellController::keepAsked);
    refresh_ = new Refresh(this, [this] { adopt(); });
    connect(&tell_, &TellController::changed, refresh_, &Refresh::request);
    refresh_->request();
  }

 protected:
  void showEvent(QShowEvent* event) override {
    tell_.hold(*this);
    QDialog::showEvent(event);
  }
  // A search that nobody waits for ends.
  void hideEvent(QHideEvent* event) override {
    tell_.hold(*this, false);
    QDialog::hideEvent(event);
  }

 private:
  QLabel* label(const char* name) {
    auto* const made = new QLabel(this);
    made->setObjectName(QLatin1String(name));
    made->setTextFormat(Qt::PlainText);
    made->setWordWrap(true);
    made->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return made;
  }
  QPushButton* button(const QString& text, const char* name) {
    auto* const made = new QPushButton(text, this);
    made->setObjectName(QLatin1String(name));
    made->setAutoDefault(false);
    return made;
  }

  void adopt() {
    const auto* const question = tell_.question();
    const Told* const told = tell_.told();
    const bool busy = tell_.isBusy();
    names_->setText(question == nullptr ? QString() : tr("A: %1\nB: %2").arg(question->a_name, question->b_name));
    verdict_->setText(told != nullptr              ? tell_.verdict()
                      : !tell_.failure().isEmpty() ? tell_.failure()
                      : busy                       ? tr("Searching the stroke in which A and B differ most…")
                                                   : tr("Nothing was searched yet, or the search was canceled."));
    bound_->setText(tell_.bound());
    QStringList details = tell_.details();
    if (tell_.isOld())
      details.prepend(tr("Another pair is compared now, or the model was edited: this is about the pair above."));
    details_->setText(details.join(QLatin1Char('\n')));
    for (QLabel* part : {bound_, details_}) part->setVisible(!part->text().isEmpty());
    const bool shown = told != nullptr && told->found.feel.rms_jnd > 0;
    plot_->setVisible(shown);
    legend_->setVisible(shown);
    if (shown) plot_->show(*told, question->a->model);
    bar_->setVisible(busy);
    bar_->setValue(static_cast<int>(100 * tell_.progress()));
    cancel_->setVisible(busy);
    for (QPushButton* act : {play_, duel_, keep_}) act->setEnabled(shown && !busy);
    if (tell_.isOld()) duel_->setEnabled(false);
    again_->setEnabled(!busy);
    refresh_->setRefining(busy);
  }

  TellController& tell_;
  QLabel* names_;
  QLabel* verdict_;
  QLabel* bound_;
  QLabel* details_;
  TellPlot* plot_;
  ElidedLabel* legend_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  QPushButton* play_;
  QPushButton* duel_;
  QPushButton* keep_;
  QPushButton* again_;
  Refresh* refresh_ = nullptr;
};

}  // namespace

QDialog* makeTellWindow(TellController& tell, QWidget* parent) { return new TellWindow(tell, parent); }

}  // namespace tactus::workbench
