#include "app/workbench/labs/speed/stroke_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/labs/data/corrections.h"
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
  auto* head = new QHBoxLayout;
  head->setSpacing(2 * theme::kGrid);
  head->addWidget(choice_);
  head->addWidget(hint, 1);
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
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid + 4, theme::kGrid / 2);
  layout->setSpacing(theme::kGrid);
  layout->addLayout(head);
  layout->addLayout(column_, 1);
  layout->addWidget(moved_);
  setMuted(*moved_);
  moved_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  moved_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  moved_->setFixedHeight(2 * QFontMetrics(moved_->font()).lineSpacing() + theme::kGrid / 2);
  moved_->hide();
  connect(&influence_, &StrokeInfluence::told, this, &StrokePage::followChosen);
  connect(choice_, &QComboBox::currentIndexChanged, this, &StrokePage::follow);
  connect(&lab_, &SpeedLab::resultChanged, this, [this] {
    if (!isVisible()) return;
    fillChoice();
    followWanted();
    follow();
  });
  connect(&lab_, &SpeedLab::pageChanged, this, &StrokePage::follow);
  connect(&traces_, &StrokeTraces::arrived, this, &StrokePage::follow);
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

void StrokePage::follow() {
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
  follow();
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
  follow();
}

void StrokePage::hideEvent(QHideEvent* event) {
  Card::hideEvent(event);
  influence_.stop();
}

}  // namespace tactus::workbench
