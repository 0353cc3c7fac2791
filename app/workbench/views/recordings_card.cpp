#include "app/workbench/views/recordings_card.h"

#include <QComboBox>
#include <QDateTime>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/controllers/feel_controller.h"
#include "app/workbench/controllers/feel_store.h"
#include "app/workbench/controllers/study_controller.h"
#include "app/workbench/display_text.h"
#include "app/workbench/theme.h"

namespace tactus::workbench {
namespace {

constexpr int kLinesShown = 3;  // of the list; more are reached by scrolling

void setMuted(QLabel* label) {
  label->setFont(theme::smallFont());
  label->setTextFormat(Qt::PlainText);
  QPalette colors = label->palette();
  colors.setColor(QPalette::WindowText, theme::mutedInk());
  label->setPalette(colors);
}

QString personText(const StudyPerson& person) {
  if (person.researcher) return RecordingsCard::tr("Researcher (%1)").arg(person.code);
  return person.simulated ? RecordingsCard::tr("%1 (simulated)").arg(person.code) : person.code;
}

// `21 Nov 19:30 · velvet-otter · 12.4 s · Virtual device · SIMULATED`.
QString recordingText(const store::FeelSummary& recording) {
  const study::FeltSetting& setting = recording.start.setting;
  QStringList parts{
      QDateTime::fromMSecsSinceEpoch(recording.start.entry.when.utc_ms).toString(QStringLiteral("d MMM HH:mm:ss")),
      text(recording.code), quantityText(recording.length_s, "s", 1)};
  if (!setting.device.empty()) parts << text(setting.device);
  if (setting.simulated) parts << RecordingsCard::tr("SIMULATED");
  if (!recording.finished) parts << RecordingsCard::tr("not finished");
  return parts.join(QStringLiteral(" · "));
}

}  // namespace

RecordingsCard::RecordingsCard(FeelStore& store, StudyController& study, FeelController& feel, QWidget* parent)
    : Card(parent),
      store_(store),
      study_(study),
      feel_(feel),
      hint_(new QLabel(tr("Open or make a study (menu Study) to keep placements and recordings."), this)),
      content_(new QWidget(this)),
      who_(new QComboBox(content_)),
      record_(new QPushButton(tr("Record"), content_)),
      list_(new QListWidget(content_)),
      state_(new QLabel(content_)),
      replay_(new QPushButton(tr("Replay"), content_)) {
  build();
  connect(who_, &QComboBox::currentIndexChanged, this, &RecordingsCard::choose);
  connect(record_, &QPushButton::clicked, this, [this] { store_.setRecording(!store_.isRecording()); });
  connect(replay_, &QPushButton::clicked, this, &RecordingsCard::replay);
  connect(list_, &QListWidget::itemSelectionChanged, this, &RecordingsCard::showState);
  connect(list_, &QListWidget::itemDoubleClicked, this, &RecordingsCard::replay);
  connect(&store_, &FeelStore::changed, this, &RecordingsCard::showState);
  connect(&study_, &StudyController::contentsChanged, this, &RecordingsCard::listPeople);
  connect(&study_, &StudyController::contentsChanged, this, &RecordingsCard::listRecordings);
  connect(&study_, &StudyController::closed, this, &RecordingsCard::showState);
  listPeople();
  listRecordings();
}

void RecordingsCard::build() {
  setMuted(hint_);
  setMuted(state_);
  hint_->setWordWrap(true);
  state_->setWordWrap(true);
  auto* who_label = new QLabel(tr("Who feels"), content_);
  who_->setAccessibleName(tr("Who feels"));
  who_->setToolTip(tr("Placements and recordings are kept as theirs"));
  who_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  who_->setMinimumContentsLength(10);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setFont(theme::smallFont());
  list_->setAccessibleName(tr("Recordings"));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setFixedHeight(kLinesShown * (QFontMetrics(theme::smallFont()).height() + 6));
  for (QPushButton* button : {record_, replay_}) {
    button->setFocusPolicy(Qt::TabFocus);
    button->setMinimumWidth(button->fontMetrics().horizontalAdvance(tr("Record")) + 5 * theme::kGrid);
  }
  auto* grid = new QGridLayout(content_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(theme::kGrid);
  grid->setVerticalSpacing(4);
  grid->addWidget(who_label, 0, 0);
  grid->addWidget(who_, 0, 1);
  grid->addWidget(record_, 0, 2);
  grid->addWidget(list_, 1, 0, 1, 3);
  grid->addWidget(state_, 2, 0, 1, 2);
  grid->addWidget(replay_, 2, 2);
  grid->setColumnStretch(1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid + 4, theme::kGrid);
  layout->addWidget(hint_);
  layout->addWidget(content_);
}

void RecordingsCard::listPeople() {
  const QSignalBlocker no_signal(who_);
  who_->clear();
  const auto& people = study_.people();
  const auto researcher = std::find_if(people.begin(), people.end(), [](const auto& one) { return one.researcher; });
  who_->addItem(researcher == people.end() ? tr("Researcher") : personText(*researcher));
  for (const StudyPerson& person : people) {
    if (person.researcher) continue;
    who_->addItem(personText(person), QString::fromStdString(study::toText(person.id)));
    if (store_.who() == person.id) who_->setCurrentIndex(who_->count() - 1);
  }
}

void RecordingsCard::listRecordings() {
  const auto* chosen = list_->currentItem();
  const QString kept = chosen != nullptr ? chosen->data(Qt::UserRole).toString() : QString();
  const auto& recordings = study_.recordings();
  {
    const QSignalBlocker no_signal(list_);
    list_->clear();
    // The newest first.
    for (auto one = recordings.rbegin(); one != recordings.rend(); ++one) {
      auto* item = new QListWidgetItem(recordingText(*one), list_);
      item->setData(Qt::UserRole, QString::fromStdString(study::toText(one->start.entry.id)));
      item->setToolTip(tr("%1\nfelt on the model %2").arg(recordingText(*one), text(one->start.setting.model)));
      if (item->data(Qt::UserRole).toString() == kept) list_->setCurrentItem(item);
    }
    if (list_->currentItem() == nullptr && list_->count() > 0) list_->setCurrentRow(0);
  }
  showState();
}

void RecordingsCard::showState() {
  const bool open = study_.isOpen();
  hint_->setVisible(!open);
  content_->setVisible(open);
  const bool replaying = store_.replayed().has_value();
  record_->setText(store_.isRecording() ? tr("End") : tr("Record"));
  record_->setToolTip(store_.isRecording() ? tr("End the recording")
                                           : tr("Record hand and force into the study, from a new placement on"));
  record_->setEnabled(store_.isRecording() || (store_.canRecord() && !replaying));
  who_->setEnabled(!store_.isRecording());
  list_->setVisible(list_->count() > 0);
  replay_->setVisible(list_->count() > 0);
  replay_->setText(replaying ? tr("Stop") : tr("Replay"));
  replay_->setToolTip(replaying ? tr("End the replay")
                                : tr("The recorded hand moves the tube through the present model, by calculation"));
  replay_->setEnabled(replaying || (list_->currentItem() != nullptr && !store_.isRecording()));
  if (replaying) {
    state_->setText(tr("Replay (SIMULATED hand): present force beside the recorded one."));
  } else if (store_.isRecording()) {
    state_->setText(feel_.isRunning() ? tr("Recording: %1").arg(quantityText(store_.recordedS(), "s", 0))
                                      : tr("The recording begins with Start."));
  } else {
    state_->setText(list_->count() > 0 ? QString() : tr("No recordings yet."));
  }
}

void RecordingsCard::choose(int person) {
  const QString id = who_->itemData(person).toString();
  store_.setWho(id.isEmpty() ? std::nullopt : study::parseRecordId(id.toStdString()));
}

void RecordingsCard::replay() {
  if (store_.replayed()) {
    feel_.stop();
    return;
  }
  const auto* item = list_->currentItem();
  if (item == nullptr) return;
  if (const auto id = study::parseRecordId(item->data(Qt::UserRole).toString().toStdString())) store_.replay(*id);
}

}  // namespace tactus::workbench
