#include "app/workbench/understand/curves/curves_panel.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QSignalBlocker>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "app/figures/force_curves.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/places.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_impact.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/curves/curve_legend.h"
#include "app/workbench/understand/curves/curve_plot.h"
#include "app/workbench/understand/curves/force_spread.h"
#include "app/workbench/understand/curves/reading_model.h"
#include "app/workbench/understand/curves/reference_controller.h"
#include "core/analysis/force_steps.h"

namespace tactus::workbench {

ReferenceBar::ReferenceBar(ReferenceController& references, const SceneController& scene, QWidget* parent)
    : QWidget(parent), references_(references), scene_(scene), against_(new QComboBox(this)) {
  against_->setAccessibleName(tr("Which curve the references are compared with"));
  against_->setToolTip(tr("Choose the curve that the references are compared with"));
  against_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(theme::kGrid);
  layout->setVerticalSpacing(2);
  layout->addWidget(against_, 0, 1, Qt::AlignTop);
  layout->setColumnStretch(0, 1);
  connect(against_, &QComboBox::activated, this, [this](int row) {
    references_.setExpert(row == 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row) - 1));
  });
  connect(&references_, &ReferenceController::changed, this, &ReferenceBar::build);
  build();
}

void ReferenceBar::build() {
  delete rows_;
  names_.clear();
  texts_.clear();
  rows_ = new QWidget(this);
  static_cast<QGridLayout*>(layout())->addWidget(rows_, 0, 0);
  auto* grid = new QGridLayout(rows_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(theme::kGrid);
  grid->setVerticalSpacing(0);
  grid->setColumnStretch(1, 1);
  const std::vector<ReferenceCurve> shown = references_.shown();
  for (const ReferenceCurve& reference : shown) {
    const int row = grid->rowCount();
    auto* name = new QLabel(QStringLiteral("● ") + reference.name, rows_);
    name->setTextFormat(Qt::PlainText);
    name->setToolTip(explained(Statistic::kRms));
    names_ << name;
    auto* difference = new ElidedLabel(rows_);
    auto* remove = new QToolButton(rows_);
    remove->setText(QStringLiteral("✕"));
    remove->setAutoRaise(true);
    remove->setToolTip(tr("Take %1 away").arg(reference.name));
    remove->setAccessibleName(remove->toolTip());
    auto* pull = new QToolButton(rows_);
    pull->setText(tr("Pull…"));
    pull->setAutoRaise(true);
    pull->setToolTip(tr("Show the edits that bring the force nearest to %1").arg(reference.name));
    pull->setAccessibleName(pull->toolTip());
    connect(pull, &QToolButton::clicked, this, [this, name = reference.name] { emit pullAsked(name); });
    for (QWidget* const part : std::initializer_list<QWidget*>{name, difference, pull, remove})
      part->setFont(theme::smallFont());
    grid->addWidget(name, row, 0);
    grid->addWidget(difference, row, 1);
    grid->addWidget(pull, row, 2);
    grid->addWidget(remove, row, 3);
    texts_ << difference;
    // Queued, because taking it away rebuilds the rows and with them the button.
    connect(
        remove, &QToolButton::clicked, this, [this, name = reference.name] { references_.remove(name); },
        Qt::QueuedConnection);
  }
  colorNames();
  listExperts();
  setVisible(!shown.empty());
  showDifferences();
}

void ReferenceBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colorNames();
}

void ReferenceBar::colorNames() {
  const std::vector<ReferenceCurve> shown = references_.shown();
  for (std::size_t i = 0; i < shown.size() && i < static_cast<std::size_t>(names_.size()); ++i) {
    QPalette colors;
    colors.setColor(QPalette::WindowText, referencePen(shown[i].color).color());
    names_[static_cast<qsizetype>(i)]->setPalette(colors);
  }
}

void ReferenceBar::listExperts() {
  const QSignalBlocker no_signal(against_);
  against_->clear();
  if (!scene_.model()) return;
  against_->addItem(tr("Mean"));
  for (const fuzzy::Expert& expert : scene_.model()->model.experts) against_->addItem(labelOf(expert));
  against_->setCurrentIndex(references_.expert() ? static_cast<int>(*references_.expert()) + 1 : 0);
}

void ReferenceBar::showDifferences() {
  if (texts_.isEmpty() || !isVisible()) return;
  const auto& differences = references_.differences();
  for (qsizetype i = 0; i < texts_.size(); ++i) {
    texts_[i]->setFullText(references_.differenceText(differences[static_cast<std::size_t>(i)]));
  }
}

namespace {

// `Fig. 11: experts and mean (lubrication 1, speed 50 mm/s)` with the labels of the model.
QString figureText(const fuzzy::ForceModel& model, const procedure::Figure& figure) {
  QStringList values;
  for (const fuzzy::Variable& input : model.inputs) {
    const auto set = figure.at.find(input.id);
    if (set != figure.at.end()) values << labelOf(input) + u' ' + quantityText(set->second, input.unit);
  }
  return QStringLiteral("%1: %2 (%3)")
      .arg(inProgramLanguage(figure.name), inProgramLanguage(figure.shows), values.join(QStringLiteral(", ")));
}

}  // namespace

FigureButton::FigureButton(SceneController& scene, QWidget* parent)
    : QPushButton(tr("Figures"), parent), scene_(scene) {
  setMenu(new QMenu(this));
  // The style leaves no air around the text.
  keepFitted(*this, [this] { setMinimumWidth(fontMetrics().horizontalAdvance(text()) + 5 * theme::kGrid); });
  setToolTip(tr("Set the inputs as in a published figure, and show the curves that it shows"));
  connect(menu(), &QMenu::aboutToShow, this, &FigureButton::showFamily);
  for (const auto signal : {&SceneController::modelChanged, &SceneController::procedureChanged})
    connect(&scene_, signal, this, &FigureButton::adoptModel);
  connect(&scene_, &SceneController::familyChanged, this, &FigureButton::showFamily);
}

void FigureButton::adoptModel() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const auto figures = figuresOf(scene_.procedure().get(), model);
  menu()->clear();
  menu()->addAction(tr("Experts and mean"), &scene_, &SceneController::clearFamily)->setCheckable(true);
  menu()->addSeparator();
  for (const procedure::Figure& one : figures) {
    QAction* action = menu()->addAction(figureText(model, one), &scene_, [this, one] { scene_.applyFigure(one); });
    action->setCheckable(!one.varied.empty());
    action->setData(inProgramLanguage(one.name));
  }
  setVisible(!figures.empty());
  showFamily();
}

void FigureButton::showFamily() {
  const QString figure = scene_.family() ? scene_.family()->figure : QString();
  setText(figure.isEmpty() ? tr("Figures") : figure);
  for (QAction* action : menu()->actions()) action->setChecked(action->data().toString() == figure);
}

namespace {

// The one table that is dragged, or an empty path.
QString draggedTable(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  if (urls.size() != 1 || !urls.first().isLocalFile()) return {};
  const QString path = urls.first().toLocalFile();
  return path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive) ? path : QString();
}

}  // namespace

CurvesPanel::CurvesPanel(SceneController& scene, ReadingModel& readings, GhostController& ghost,
                         ReferenceController& references, QWidget* parent)
    : Card(parent),
      scene_(scene),
      readings_(readings),
      ghost_(ghost),
      references_(references),
      title_(new QLabel(this)),
      x_input_(new QComboBox(this)),
      plot_(new CurvePlot(scene.ranges(), this)),
      menu_(new PlotMenu(
          *plot_, [this] { return table(); }, this)),
      legend_(new CurveLegend(this)),
      ghost_chip_(new LegendChip(ghostLook(tr("Before the last edit")), {}, this)),
      difference_(new ElidedLabel(this)),
      go_there_(new QToolButton(this)),
      step_(new ElidedLabel(this)),
      reference_bar_(new ReferenceBar(references, scene, this)),
      draw_curves_(new Refresh(this, [this] { drawCurves(); })),
      draw_ghost_(new Refresh(this, [this] { drawGhost(); })),
      draw_references_(new Refresh(this, [this] { drawReferences(); })),
      draw_reading_(new Refresh(this, [this] { showReading(); })) {
  title_->setFont(theme::headingFont());
  title_->setTextFormat(Qt::PlainText);
  title_->setBuddy(x_input_);
  x_input_->setAccessibleName(tr("Input on the x axis"));
  x_input_->setSizeAdjustPolicy(QComboBox::AdjustToContents);

  difference_->setFont(theme::smallFont());
  go_there_->setText(tr("Go there"));
  go_there_->setToolTip(tr("Move the operating point to where the last edit changes the force most"));
  go_there_->hide();
  ghost_chip_->setChecked(ghost_.isOn());
  ghost_chip_->setBrief(tr("Before"));
  setAcceptDrops(true);
  step_->setFont(theme::smallFont());
  setInk(*step_, theme::errorInk());
  step_->hide();
  for (ElidedLabel* label : {difference_, step_}) label->setHint(explained(Statistic::kNoticeable));

  auto* pull = new QPushButton(tr("Pull…"), this);
  pull->setToolTip(
      tr("Show the smallest edits for a force that you want here. On the curves: Alt and drag a line, or "
         "Alt, Shift and drag for a band"));
  connect(pull, &QPushButton::clicked, this, &CurvesPanel::pullAsked);
  connect(reference_bar_, &ReferenceBar::pullAsked, this, &CurvesPanel::pullToReferenceAsked);
  // A hidden label takes no room; then the spring does.
  auto* head = makeRow({title_, x_input_, {step_, 100}, spring(1), pull, new FigureButton(scene, this), menu_});
  legend_->setTail({ghost_chip_, go_there_, difference_});
  makeColumn(this, {head, legend_, {plot_, 1}, reference_bar_}, theme::kGrid / 2,
             {theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid});

  connect(x_input_, &QComboBox::activated, this, &CurvesPanel::onXInputChosen);
  connect(plot_, &CurvePlot::hovered, &scene_, &SceneController::setHover);
  connect(plot_, &CurvePlot::originAsked, this, &CurvesPanel::originAsked);
  connect(plot_, &CurvePlot::hoverLeft, &scene_, &SceneController::clearHover);
  connect(plot_, &CurvePlot::picked, &scene_, [this](double x) { scene_.setValue(scene_.xInput(), x); });
  connect(plot_, &CurvePlot::marked, this, &CurvesPanel::onMarked);
  connect(plot_, &CurvePlot::grabbed, this, &CurvesPanel::grabbed);
  connect(plot_, &CurvePlot::bandDrawn, this, &CurvesPanel::bandDrawn);
  connect(plot_, &CurvePlot::pulledTo, this, &CurvesPanel::pulledTo);
  connect(plot_, &CurvePlot::pullReleased, this, &CurvesPanel::pullReleased);
  connect(plot_, &CurvePlot::pullStepped, this, &CurvesPanel::pullStepped);
  connect(plot_, &CurvePlot::pullDropped, this, &CurvesPanel::pullDropped);
  connect(plot_, &CurvePlot::pullAsked, this, &CurvesPanel::pullAsked);
  connect(plot_, &CurvePlot::pinAsked, this, &CurvesPanel::pinAsked);
  connect(plot_, &CurvePlot::placeStepped, &scene_, [this](int steps) {
    const double to = scene_.value(scene_.xInput()) + steps * stepOf(scene_.xVariable());
    scene_.setValue(scene_.xInput(), placeOf(scene_.xVariable(), to));
  });
  setFocusProxy(plot_);
  connect(&readings, &ReadingModel::rowShownChanged, this, &CurvesPanel::onRowShown);
  connect(&scene_, &SceneController::modelChanged, this, &CurvesPanel::adoptModel);
  connect(&scene_, &SceneController::xInputChanged, this, &CurvesPanel::showAxes);
  connect(&scene_, &SceneController::termsChanged, this, &CurvesPanel::showTerms);
  connect(&scene_, &SceneController::familyChanged, this, &CurvesPanel::showFamily);
  connect(&scene_, &SceneController::curvesChanged, draw_curves_, &Refresh::request);
  connect(&scene_, &SceneController::readingChanged, draw_reading_, &Refresh::request);
  connect(ghost_chip_, &LegendChip::toggled, &ghost_, &GhostController::setOn);
  connect(&ghost_, &GhostController::changed, draw_ghost_, &Refresh::request);
  connect(&scene_, &SceneController::curvesChanged, draw_ghost_, &Refresh::request);
  connect(go_there_, &QToolButton::clicked, this, [this] {
    if (const auto there = ghost_.elsewhere()) scene_.goTo(there->at);
  });
  connect(&references_, &ReferenceController::changed, draw_references_, &Refresh::request);
  draw_ghost_->request();
}

void CurvesPanel::showReading() {
  const double from = mark_.value_or(scene_.value(scene_.xInput()));
  std::optional<fuzzy::Evaluation> left_behind;
  if (scene_.readingX() != from) {
    std::vector<double> there = scene_.values();
    there[scene_.xInput()] = from;
    left_behind = scene_.model()->compiled.evaluate(there);
    scene_.countEvaluations(1);
  }
  plot_->setReading(scene_.reading(), from, left_behind);
}

void CurvesPanel::setMark(std::optional<double> x) {
  if (x == mark_) return;
  mark_ = x;
  mark_input_ = scene_.xVariable().id;
  draw_reading_->request();
  emit markChanged();
}

// A click near the cursor takes it away.
void CurvesPanel::onMarked(double x) {
  constexpr double kNear = 0.01;  // of the range that is shown
  const figures::Interval shown = scene_.ranges().of(scene_.xVariable());
  const bool again = mark_ && std::abs(*mark_ - x) < kNear * (shown.high - shown.low);
  setMark(again ? std::nullopt : std::optional(x));
}

void CurvesPanel::setFast(bool fast) { plot_->setFast(fast); }

void CurvesPanel::setSimulators(std::vector<SimulatorMark> marks) { plot_->setSimulators(std::move(marks)); }

void CurvesPanel::setPull(const PullMarks* pull) { plot_->setPull(pull); }

QPoint CurvesPanel::pixelOf(double x, double force_n) const { return plot_->mapTo(this, plot_->pixelOf(x, force_n)); }

void CurvesPanel::setSpreadShown(SpreadShown shown) {
  plot_->setSpreadShown(shown);
  if (!scene_.model()) return;
  showLegend();
  draw_curves_->request();
}

void CurvesPanel::changeEvent(QEvent* event) {
  Card::changeEvent(event);
  if (event->type() != QEvent::PaletteChange || !scene_.model()) return;
  // What lines and swatches took from the other look.
  ghost_chip_->setLook(ghostLook(ghost_chip_->text()));
  setInk(*step_, theme::errorInk());
  showLegend();
  draw_ghost_->request();
  draw_references_->request();
}

void CurvesPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (!draggedTable(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void CurvesPanel::dropEvent(QDropEvent* event) {
  const QString path = draggedTable(*event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  references_.open(path);
}

void CurvesPanel::drawCurves() {
  plot_->setCurves(scene_.curves());
  drawSteps();
  if (scene_.family()) plot_->setFamilyCurves(scene_.familyCurves());
  reference_bar_->showDifferences();
}

// Also while a vertex is dragged: a cliff is seen before it is felt.
void CurvesPanel::drawSteps() {
  const OpenModel& open = *scene_.model();
  auto steps = figures::noticeableSteps(open.model, open.compiled, scene_.xInput(), scene_.values());
  plot_->setSteps(steps);
  std::erase_if(steps, [&](const analysis::ForceStep& step) {
    return step.expert ? !plot_->isExpertShown(*step.expert) : !plot_->isMeanShown();
  });
  step_->setVisible(!steps.empty());
  if (steps.empty()) return;
  const auto largest = std::max_element(
      steps.begin(), steps.end(), [](const auto& one, const auto& other) { return one.noticeable < other.noticeable; });
  const QString who = largest->expert ? text(open.model.experts[*largest->expert].id) : tr("Mean");
  step_->setFullText(tr("%1: step %2 to %3 (%4 JND) at %5")
                         .arg(who, forceText(largest->from_n, open.model.output.unit),
                              forceText(largest->to_n, open.model.output.unit), numberText(largest->noticeable, 1),
                              placeText(scene_.xVariable(), largest->from[largest->input])));
}

void CurvesPanel::drawGhost() {
  const bool any = ghost_.before() || !ghost_.isOn();
  plot_->setGhost(ghost_.curves(), ghost_.label());
  ghost_chip_->setEnabled(any);
  ghost_chip_->setName(ghost_.label());
  ghost_chip_->setToolTip(ghost_.whatChanged().isEmpty() ? tr("Show the curves before an edit as dashed lines")
                                                         : tr("Since then: %1").arg(ghost_.whatChanged()));
  difference_->setFullText(any ? ghost_.differenceText() : QString(), ghost_.briefText());
  go_there_->setVisible(ghost_.elsewhere().has_value());
}

void CurvesPanel::drawReferences() {
  plot_->setReferences(references_.shown());
  reference_bar_->showDifferences();
}

void CurvesPanel::adoptModel() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  title_->setText(tr("%1 along").arg(labelOf(model.output)));

  const QSignalBlocker no_signal(x_input_);
  x_input_->clear();
  for (const fuzzy::Variable& input : model.inputs) x_input_->addItem(axisText(input));

  showAxes();
  draw_curves_->request();
  draw_reading_->request();
}

void CurvesPanel::showAxes() {
  const QSignalBlocker no_signal(x_input_);
  x_input_->setCurrentIndex(static_cast<int>(scene_.xInput()));
  const fuzzy::ForceModel& model = scene_.model()->model;
  if (mark_input_ != scene_.xVariable().id) setMark(std::nullopt);
  plot_->setAxes(scene_.xVariable(), model.output, model.experts);
  showFamily();
  showTerms();
  draw_ghost_->request();
  draw_references_->request();
}

// The lines of the mean and of the experts, or of a family in their place.
void CurvesPanel::showFamily() {
  QStringList names;
  const std::size_t lines = scene_.family() ? scene_.family()->values.size() : 0;
  for (std::size_t i = 0; i < lines; ++i) names << familyLineText(scene_.model()->model, *scene_.family(), i);
  plot_->setFamily(names);
  showLines();
  showLegend();
  draw_curves_->request();
  draw_ghost_->request();
  draw_reading_->request();
}

// Another axis brings new lines, and what was hidden stays hidden.
void CurvesPanel::showLines() {
  for (int row = 0; row < readings_.rowCount(); ++row) showLine(row);
}

void CurvesPanel::showLine(int row) {
  const bool shown = readings_.isShown(row);
  if (row == ReadingModel::kMeanRow) {
    plot_->setMeanShown(shown);
  } else {
    plot_->setExpertShown(static_cast<std::size_t>(row) - 1, shown && !scene_.family());
  }
}

void CurvesPanel::showLegend() {
  legend_->setItems(curveItems(scene_, *plot_, readings_, [this] {
    draw_curves_->request();
    emit spreadChosen(plot_->spreadShown());
  }));
}

void CurvesPanel::showTerms() {
  plot_->setTerms(scene_.xVariable(), scene_.terms(scene_.xVariable()), scene_.model()->model.events);
}

void CurvesPanel::onXInputChosen(int index) { scene_.setXInput(static_cast<std::size_t>(index)); }

void CurvesPanel::onRowShown(int row) {
  showLine(row);
  draw_curves_->request();
  if (const auto item = curveItemOf(scene_, row)) legend_->setShown(*item, readings_.isShown(row));
  draw_ghost_->request();
  draw_reading_->request();
}

PlotTable CurvesPanel::table() {
  // Hidden, the plot has followed nothing.
  drawCurves();
  drawGhost();
  drawReferences();
  ShownCurves shown{plot_->isMeanShown(), {}, {}, false, false};
  const std::size_t experts = scene_.model()->model.experts.size();
  for (std::size_t i = 0; i < experts; ++i) shown.experts.push_back(plot_->isExpertShown(i));
  if (scene_.family()) {
    for (std::size_t i = 0; i < scene_.family()->values.size(); ++i) shown.family.push_back(plot_->isFamilyShown(i));
  } else {
    shown.range = plot_->spreadShown().range && experts >= 2;
    shown.deviation = plot_->spreadShown().deviation && experts >= kFewestForDeviation;
  }
  return curveTable(scene_, shown, notes());
}

// What is compared with the curves, in words: its numbers have places of their own and stand in no column.
QStringList CurvesPanel::notes() const {
  QStringList out;
  if (ghost_.curves()) {
    const QString since =
        ghost_.whatChanged().isEmpty() ? QString() : tr(" (since then: %1)").arg(ghost_.whatChanged());
    out << tr("Dashed: %1%2, %3").arg(ghost_.label(), since, ghost_.differenceText());
  }
  const std::vector<ReferenceCurve> shown = references_.shown();
  const auto& differences = references_.differences();
  const QString against =
      references_.expert() ? labelOf(scene_.model()->model.experts[*references_.expert()]) : tr("the mean");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    out << tr("Reference %1 and %2: %3").arg(shown[i].name, against, references_.differenceText(differences[i]));
  }
  return out;
}

}  // namespace tactus::workbench
