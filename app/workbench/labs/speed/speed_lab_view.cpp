#include "app/workbench/labs/speed/speed_lab_view.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/frame/lab_card.h"
#include "app/workbench/labs/speed/cluster_page.h"
#include "app/workbench/labs/speed/number_page.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/labs/speed/trace_row.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kMostRows = SpeedLab::kPerPage;

}  // namespace

StrokePage::StrokePage(SpeedLab& lab, LabModel& model, Corrections& corrections, QWidget* parent)
    : Card(parent),
      lab_(lab),
      corrections_(corrections),
      traces_(lab.data()),
      influence_(model),
      choice_(new QComboBox(this)),
      moved_(new WrappedLabel(this)),
      column_(new QVBoxLayout) {
  auto* hint = new QLabel(tr("Click a stroke to see what it moves. Drag a mark to correct where a stroke begins or "
                             "ends; right-click a stroke to leave it "
                             "out. A correction is a new record: the old one stays in the study."),
                          this);
  setMuted(*hint);
  hint->setWordWrap(true);
  choice_->setAccessibleName(tr("Strokes that are shown"));
  choice_->setMinimumWidth(26 * theme::kGrid);
  auto* head = makeRow({choice_, {hint, 1}}, 2 * theme::kGrid);
  column_->setSpacing(theme::kGrid / 2);
  for (std::size_t i = 0; i < kMostRows; ++i) {
    auto* row = new TraceRow(this);
    connect(row, &TraceRow::marked, this,
            [this](const auto& before, const auto& wanted) { correct(before, wanted, true); });
    connect(row, &TraceRow::judged, this,
            [this](const auto& before, const auto& wanted) { correct(before, wanted, false); });
    connect(row, &TraceRow::strokeChosen, this, &StrokePage::choose);
    column_->addWidget(row, 1);
    rows_.push_back(row);
  }
  makeColumn(this, {head, {column_, 1}, moved_}, theme::kGrid,
             {theme::kGrid + 4, theme::kGrid, theme::kGrid + 4, theme::kGrid / 2});
  setMuted(*moved_);
  moved_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  moved_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  moved_->setFixedHeight(2 * QFontMetrics(moved_->font()).lineSpacing() + theme::kGrid / 2);
  moved_->hide();
  connect(&influence_, &StrokeInfluence::told, this, &StrokePage::followChosen);
  connect(choice_, &QComboBox::currentIndexChanged, this, &StrokePage::refreshState);
  connect(&lab_, &SpeedLab::resultChanged, this, [this] {
    if (!isVisible()) return;
    fillChoice();
    followWanted();
    refreshState();
  });
  connect(&lab_, &SpeedLab::pageChanged, this, &StrokePage::refreshState);
  connect(&traces_, &StrokeTraces::arrived, this, &StrokePage::refreshState);
  connect(&corrections_, &Corrections::refused, this, &StrokePage::putBack);
}

// Levels come first, as in Fig. 6; the fastest is shown at the beginning.
void StrokePage::fillChoice() {
  const auto& result = lab_.result();
  QStringList wanted;
  if (result) {
    for (const fuzzy::Term& term : result->speed.terms) wanted << tr("%1 strokes of all").arg(labelOf(term));
    for (const auto& subject : result->subjects) {
      wanted << tr("All levels of %1").arg(text(subject->speeds.participant));
    }
  }
  QStringList there;
  for (int i = 0; i < choice_->count(); ++i) there << choice_->itemText(i);
  if (wanted == there) return;
  const QSignalBlocker quiet(choice_);
  choice_->clear();
  choice_->addItems(wanted);
  if (result) choice_->setCurrentIndex(static_cast<int>(result->speed.terms.size()) - 1);
}

std::vector<StrokePage::Cell> StrokePage::cells() const {
  std::vector<Cell> out;
  const auto& result = lab_.result();
  if (!result || choice_->currentIndex() < 0) return out;
  const std::vector<std::size_t> numbers = subjectNumbers(*result);
  const auto index = static_cast<std::size_t>(choice_->currentIndex());
  const auto add = [&](std::size_t who, const fuzzy::Term& level) {
    const elicitation::ParticipantSpeeds& one = result->subjects[who]->speeds;
    const QString name = one.simulated ? tr("%1 (simulated)").arg(text(one.participant)) : text(one.participant);
    out.push_back({one.participant, level.id, tr("%1 · %2").arg(name, labelOf(level)), numbers[who]});
  };
  const auto& levels = result->speed.terms;
  if (index < levels.size()) {
    const auto [first, last] = lab_.shown();
    for (std::size_t who = first; who < last; ++who) add(who, levels[index]);
  } else if (index - levels.size() < result->subjects.size()) {
    for (std::size_t level = 0; level < std::min(kMostRows, levels.size()); ++level) {
      add(index - levels.size(), levels[level]);
    }
  }
  return out;
}

void StrokePage::refreshState() {
  if (!isVisible()) return;
  const std::vector<Cell> shown = cells();
  std::vector<std::shared_ptr<const StrokeSet>> sets;
  double highest = 0;
  for (const Cell& cell : shown) {
    sets.push_back(traces_.strokes(cell.participant, cell.level));
    highest = std::max(highest, TraceRow::highestOf(sets.back().get()));
  }
  const double top_mm_s = TraceRow::topOf(highest);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i]->setVisible(i < shown.size());
    if (i < shown.size()) rows_[i]->show(shown[i].title, theme::expert(shown[i].number), sets[i], top_mm_s);
  }
  followChosen();
}

void StrokePage::choose(const study::StrokeRecord& record) {
  const std::string participant =
      lab_.data().study() ? lab_.data().study()->codeOf(record.entry.session) : std::string();
  const QString which =
      tr("Stroke %1 of %2, %3").arg(record.number).arg(harmless(text(participant)), text(record.level));
  influence_.ask({participant, record.level, record.number}, which);
}

void StrokePage::showStroke(const elicitation::StrokeKey& stroke) {
  wanted_ = stroke;
  followWanted();
}

void StrokePage::followWanted() {
  const auto& result = lab_.result();
  if (!wanted_ || !result || !isVisible()) return;
  for (std::size_t i = 0; i < result->subjects.size(); ++i) {
    if (result->subjects[i]->speeds.participant != wanted_->participant) continue;
    choice_->setCurrentIndex(static_cast<int>(result->speed.terms.size() + i));
    influence_.ask(
        *wanted_,
        tr("Stroke %1 of %2, %3").arg(wanted_->stroke).arg(harmless(text(wanted_->participant)), text(wanted_->level)));
  }
  wanted_.reset();
}

// The chosen stroke on its row, and what it moves below all rows.
void StrokePage::followChosen() {
  const auto& asked = influence_.asked();
  const std::vector<Cell> shown = cells();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool here =
        asked && i < shown.size() && shown[i].participant == asked->participant && shown[i].level == asked->level;
    rows_[i]->setChosen(here ? std::optional(asked->stroke) : std::nullopt);
  }
  moved_->setText(influence_.sentence());
  moved_->setVisible(!influence_.sentence().isEmpty());
}

// A mark that was not stored goes back.
void StrokePage::putBack() {
  for (TraceRow* row : rows_) row->show({}, {}, nullptr, 1);
  refreshState();
}

void StrokePage::correct(const study::StrokeRecord& before, const study::StrokeRecord& wanted, bool marks) {
  if (corrections_.isBusy()) {
    putBack();
    return;
  }
  const QString who = text(lab_.data().study() ? lab_.data().study()->codeOf(before.entry.session) : std::string());
  const QString stroke = tr("stroke %1 of %2, %3").arg(before.number).arg(who, text(before.level));
  if (marks) {
    corrections_.correct(before, wanted, tr("marks of %1").arg(stroke), QStringLiteral("marks_corrected"));
  } else {
    const bool out = wanted.verdict != "accepted";
    corrections_.correct(before, wanted, out ? tr("%1 left out").arg(stroke) : tr("%1 counted again").arg(stroke),
                         out ? QStringLiteral("left_out") : QStringLiteral("counted_again"));
  }
}

void StrokePage::showEvent(QShowEvent* event) {
  Card::showEvent(event);
  fillChoice();
  followWanted();
  refreshState();
}

void StrokePage::hideEvent(QHideEvent* event) {
  Card::hideEvent(event);
  influence_.stop();
}

namespace {

using elicitation::Averaging;
using elicitation::SpeedCentres;

QLabel* makeCaption(const QString& words, QWidget* buddy, QWidget* parent) {
  auto* caption = new QLabel(words, parent);
  caption->setBuddy(buddy);
  return caption;
}

}  // namespace

SpeedSettingsPanel::SpeedSettingsPanel(SpeedLab& lab, QWidget* parent)
    : Card(parent),
      lab_(lab),
      clusters_(new SettingRow(tr("Clusters c"),
                               tr("The model has one term for each cluster: another number shows clusters alone."),
                               {2, 8, 1, {}, true}, this)),
      fuzziness_(new SettingRow(tr("Fuzziness m"),
                                tr("The exponent m of Eq. 1: near 1 the clusters are crisp; above 5 the centers "
                                   "stick to samples."),
                                {1.05, 6, 0.05}, this)),
      alpha_(new SettingRow(tr("Ramp end α"),
                            tr("The membership at the ends of a ramp. 1: center points have membership 1, as the "
                               "paper says, and medium is a triangle. 0.95: the ramp fits the membership best."),
                            {0.51, 1, 0.01}, this)),
      trim_(new SettingRow(tr("Trimming"),
                           tr("Samples below this share of their stroke's peak speed are left out: the start and the "
                              "stop of each stroke."),
                           {0, 0.95, 0.01}, this)),
      centres_(new QComboBox(this)),
      averaging_(new QComboBox(this)),
      note_(new QLabel(this)) {
  centres_->addItem(tr("clusters of all samples"));
  centres_->addItem(tr("means of the levels"));
  centres_->setAccessibleName(tr("Centers of the terms"));
  averaging_->addItem(tr("mean"));
  averaging_->addItem(tr("weighted mean"));
  averaging_->addItem(tr("median"));
  averaging_->setAccessibleName(tr("Average over the participants"));
  setMuted(*note_);
  note_->setWordWrap(true);
  auto* title = new QLabel(tr("Settings"), this);
  title->setFont(theme::headingFont());
  auto* defaults = new QPushButton(tr("Reset to &defaults"), this);
  makeColumn(this,
             {title, clusters_, fuzziness_, alpha_, trim_, makeCaption(tr("Centers"), centres_, this), centres_,
              makeCaption(tr("Average"), averaging_, this), averaging_, defaults, note_, spring(1)},
             theme::kGrid, {2 * theme::kGrid, theme::kGrid + 4, 2 * theme::kGrid, 2 * theme::kGrid});

  connect(clusters_, &SettingRow::changed, this,
          [this](double value) { lab_.setClusters(static_cast<std::size_t>(value)); });
  connect(fuzziness_, &SettingRow::changed, &lab_, &SpeedLab::setFuzziness);
  connect(alpha_, &SettingRow::changed, &lab_, &SpeedLab::setAlpha);
  connect(trim_, &SettingRow::changed, &lab_, &SpeedLab::setTrim);
  connect(centres_, &QComboBox::currentIndexChanged, this,
          [this](int index) { lab_.setCentres(index == 1 ? SpeedCentres::kLevelMeans : SpeedCentres::kClusters); });
  connect(averaging_, &QComboBox::currentIndexChanged, this,
          [this](int index) { lab_.setAveraging(static_cast<Averaging>(index)); });
  connect(defaults, &QPushButton::clicked, &lab_, &SpeedLab::setDefaults);
  connect(&lab_, &SpeedLab::settingsChanged, this, &SpeedSettingsPanel::refreshState);
  refreshState();
}

void SpeedSettingsPanel::refreshState() {
  const elicitation::SpeedTermSettings& settings = lab_.settings();
  const bool means = settings.centres == SpeedCentres::kLevelMeans;
  clusters_->setValue(static_cast<double>(lab_.clusters()));
  clusters_->setEnabled(!means);
  fuzziness_->setValue(settings.fcm.m);
  alpha_->setValue(settings.alpha);
  trim_->setValue(settings.trim);
  const QSignalBlocker quiet_centres(centres_);
  const QSignalBlocker quiet_averaging(averaging_);
  centres_->setCurrentIndex(means ? 1 : 0);
  averaging_->setCurrentIndex(static_cast<int>(lab_.averaging()));
  note_->setText(
      !means && lab_.clusters() != 3
          ? tr("With %1 clusters there are no terms: the model has three, Slow, Medium and Fast.").arg(lab_.clusters())
          : tr("These settings make the model of all labs, and are stored in it."));
}

namespace {

constexpr int kSettingsWidth = 29 * theme::kGrid;  // px at 100 %

}  // namespace

SpeedLabView::SpeedLabView(SpeedLab& lab, LabModel& model, Corrections& corrections, const SettingsPrice& price,
                           QWidget* parent)
    : LabView(
          QStringLiteral("speed"), tr("Speed"), [&lab](bool wanted) { lab.setSeen(wanted); }, parent),
      lab_(lab),
      terms_(nullptr),
      strokes_(new StrokePage(lab, model, corrections, this)),
      pages_(makeTabs(this)),
      back_(new QToolButton(this)),
      on_(new QToolButton(this)),
      place_(new QLabel(this)),
      nothing_(new QLabel(this)) {
  auto* settings = new SpeedSettingsPanel(lab, this);
  keepFitted(*settings, [settings] { settings->setFixedWidth(appearance::scaled(kSettingsWidth)); });
  auto* const numbers = new NumberPage(lab, this);
  strokes_->setObjectName(QStringLiteral("strokes"));
  numbers->setObjectName(QStringLiteral("table"));
  auto* const clusters = new ClusterPage(lab, price, this);
  terms_ = &clusters->terms();
  pages_->addTab(clusters, tr("Clusters and terms"));
  pages_->addTab(strokes_, tr("Strokes"));
  pages_->addTab(numbers, tr("Table 1 and warnings"));
  pages_->setCornerWidget(makePager(), Qt::TopRightCorner);
  setMuted(*nothing_);
  nothing_->setAlignment(Qt::AlignCenter);
  nothing_->setWordWrap(true);
  nothing_->hide();
  makeRow(this, {settings, {pages_, 1}, {nothing_, 1}});
  connect(&lab_, &SpeedLab::resultChanged, this, &SpeedLabView::refreshState);
  connect(&lab_, &SpeedLab::pageChanged, this, &SpeedLabView::refreshState);
  refreshState();
}

QWidget* SpeedLabView::makePager() {
  auto* pager = new QWidget(this);
  back_->setArrowType(Qt::LeftArrow);
  back_->setAccessibleName(tr("Earlier participants"));
  on_->setArrowType(Qt::RightArrow);
  on_->setAccessibleName(tr("Further participants"));
  setMuted(*place_);
  makeRow(pager, {back_, place_, on_}, theme::kGrid / 2);
  connect(back_, &QToolButton::clicked, this, [this] { lab_.setPage(lab_.page() - 1); });
  connect(on_, &QToolButton::clicked, this, [this] { lab_.setPage(lab_.page() + 1); });
  return pager;
}

void SpeedLabView::showStroke(const elicitation::StrokeKey& stroke) {
  pages_->setCurrentWidget(strokes_);
  strokes_->showStroke(stroke);
}

void SpeedLabView::refreshState() {
  const auto& result = lab_.result();
  const bool empty = result && result->subjects.empty();
  nothing_->setText(
      tr("There are no accepted strokes in this study. The speed has its default terms; the speed "
         "experiment begins in Collect."));
  nothing_->setVisible(empty);
  pages_->setVisible(!empty);
  const auto [first, last] = lab_.shown();
  for (QWidget* part : {static_cast<QWidget*>(back_), static_cast<QWidget*>(on_), static_cast<QWidget*>(place_)}) {
    part->setVisible(lab_.pages() > 1);
  }
  place_->setText(tr("%1 to %2 of %3").arg(first + 1).arg(last).arg(result ? result->subjects.size() : 0));
  back_->setEnabled(lab_.page() > 0);
  on_->setEnabled(lab_.page() + 1 < lab_.pages());
}

}  // namespace tactus::workbench
