#include "app/workbench/feel/recordings/recordings_card.h"

#include <QComboBox>
#include <QDateTime>
#include <QGridLayout>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/recordings/feel_marks.h"
#include "app/workbench/feel/recordings/feel_store.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {
namespace {

QString personText(const StudyPerson& person) {
  if (person.researcher) return RecordingsCard::tr("Researcher (%1)").arg(person.code);
  return person.simulated ? RecordingsCard::tr("%1 (simulated)").arg(person.code) : person.code;
}

// `19:30:12 · 12.4 s · velvet-otter · Virtual device (simulated)`, with the day where it is not today.
QString recordingText(const store::FeelSummary& recording, bool goes_on) {
  const study::FeltSetting& setting = recording.start.setting;
  const QDateTime when = QDateTime::fromMSecsSinceEpoch(recording.start.entry.when.utc_ms);
  const bool today = when.date() == QDate::currentDate();
  QStringList parts{when.toString(today ? QStringLiteral("HH:mm:ss") : QStringLiteral("d MMM yyyy HH:mm"))};
  if (goes_on) {
    parts << RecordingsCard::tr("recording…");
  } else {
    parts << quantityText(recording.length_s, "s", 1);
    if (!recording.finished) parts << RecordingsCard::tr("not finished");
  }
  parts << text(recording.code);
  const QString device = text(setting.device);
  if (setting.simulated && !device.contains(QLatin1String("simulated"), Qt::CaseInsensitive)) {
    parts << RecordingsCard::tr("SIMULATED");
  }
  if (!device.isEmpty()) parts << device;
  return parts.join(QStringLiteral(" · "));
}

// A red dot for a recording in progress, a ring for one that waits for Start.
QIcon recordIcon(bool in_progress) {
  constexpr int kSide = 16;
  QPixmap picture(kSide, kSide);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme::errorInk(), 2));
  painter.setBrush(in_progress ? QBrush(theme::errorInk()) : QBrush(Qt::NoBrush));
  painter.drawEllipse(QRectF(3, 3, kSide - 6, kSide - 6));
  return picture;
}

constexpr int kOneRow = 760;  // px: from this width on everything stands in one row

}  // namespace

RecordingsCard::RecordingsCard(FeelStore& store, StudyConnection& study, FeelController& feel, QWidget* parent)
    : Card(parent),
      store_(store),
      study_(study),
      feel_(feel),
      hint_(new QLabel(tr("A study keeps what is felt: one file, a new one or one that is there."), this)),
      into_(new QPushButton(tr("Record into a study…"), this)),
      where_(new QLabel(this)),
      content_(new QWidget(this)),
      grid_(new QGridLayout(content_)),
      who_label_(new QLabel(tr("Who feels"), content_)),
      list_label_(new QLabel(tr("Recordings"), content_)),
      who_(new QComboBox(content_)),
      record_(new QPushButton(tr("Record"), content_)),
      list_(new QComboBox(content_)),
      replay_(new QPushButton(tr("Replay"), content_)) {
  build();
  connect(into_, &QPushButton::clicked, this, &RecordingsCard::studyRequested);
  connect(who_, &QComboBox::currentIndexChanged, this, &RecordingsCard::choose);
  connect(record_, &QPushButton::clicked, this, [this] { store_.setRecording(!store_.isRecording()); });
  connect(replay_, &QPushButton::clicked, this, &RecordingsCard::replay);
  connect(&store_, &FeelStore::changed, this, &RecordingsCard::showState);
  connect(&study_, &StudyConnection::contentsChanged, this, &RecordingsCard::listPeople);
  connect(&study_, &StudyConnection::contentsChanged, this, &RecordingsCard::listRecordings);
  connect(&study_, &StudyConnection::closed, this, &RecordingsCard::showState);
  connect(&feel_, &FeelController::stateChanged, this, &RecordingsCard::showState);
  listPeople();
  listRecordings();
}

void RecordingsCard::build() {
  setMuted(*hint_);
  hint_->setTextFormat(Qt::PlainText);
  hint_->setWordWrap(true);
  into_->setToolTip(tr("Choose the study file; the recording then begins with Start (F9)"));
  into_->setFocusPolicy(Qt::TabFocus);
  where_->setTextFormat(Qt::PlainText);
  where_->setFont(theme::smallFont());
  setMuted(*where_);
  who_->setAccessibleName(tr("Who feels"));
  who_->setToolTip(tr("Choose for whom placements and recordings are stored"));
  list_->setAccessibleName(tr("Recordings"));
  for (QComboBox* box : {who_, list_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(10);
  }
  for (QPushButton* button : {record_, replay_}) {
    button->setFocusPolicy(Qt::TabFocus);
    // Wide enough for every word and number that comes on it.
    keepFitted(*button, [button] {
      button->setMinimumWidth(button->fontMetrics().horizontalAdvance(tr("End · %1 s").arg(999)) + 5 * theme::kGrid);
    });
  }
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(theme::kGrid);
  grid_->setVerticalSpacing(4);
  arrange();
  makeColumn(this, {makeRow({{hint_, 1}, {into_, 0, Qt::AlignVCenter}}), where_, content_}, kStyleGap,
             inset(theme::kGrid + 4, theme::kGrid));
}

void RecordingsCard::arrange() {
  const QList<QWidget*> first{who_label_, who_, record_};
  const QList<QWidget*> second{list_label_, list_, replay_};
  for (QWidget* part : first + second) grid_->removeWidget(part);
  for (int i = 0; i < 3; ++i) {
    grid_->addWidget(first[i], 0, i);
    grid_->addWidget(second[i], in_one_row_ ? 0 : 1, in_one_row_ ? 3 + i : i);
  }
  grid_->setColumnStretch(1, 1);
  grid_->setColumnStretch(4, in_one_row_ ? 2 : 0);
}

void RecordingsCard::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  const bool in_one_row = width() >= std::max(kOneRow, widthInOneRow());
  if (in_one_row == in_one_row_) return;
  in_one_row_ = in_one_row;
  arrange();
  showState();
}

int RecordingsCard::widthInOneRow() const {
  const QMargins edges = layout()->contentsMargins();
  int width = edges.left() + edges.right() - grid_->horizontalSpacing();
  for (const QWidget* part :
       std::initializer_list<const QWidget*>{who_label_, who_, record_, list_label_, list_, replay_}) {
    width += std::max(part->minimumWidth(), part->minimumSizeHint().width()) + grid_->horizontalSpacing();
  }
  return width;
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
  }
  showWho();
}

void RecordingsCard::showWho() {
  const QSignalBlocker no_signal(who_);
  const auto who = store_.who();
  const int index = who ? who_->findData(QString::fromStdString(study::toText(*who))) : 0;
  who_->setCurrentIndex(index);
}

void RecordingsCard::listRecordings() {
  const QString kept = list_->currentData().toString();
  const auto& recordings = study_.recordings();
  // The recording that has just begun is the most interesting one.
  const bool is_new = std::exchange(listed_, recordings.size()) < recordings.size();
  list_->clear();
  // The newest first.
  for (auto one = recordings.rbegin(); one != recordings.rend(); ++one) {
    const bool goes_on = store_.isRecording() && feel_.isRunning() && one == recordings.rbegin() && !one->finished;
    const QString line = recordingText(*one, goes_on);
    list_->addItem(line, QString::fromStdString(study::toText(one->start.entry.id)));
    list_->setItemData(list_->count() - 1, tr("%1\nfelt on the model %2").arg(line, text(one->start.setting.model)),
                       Qt::ToolTipRole);
  }
  const int again = list_->findData(kept);
  if (list_->count() > 0) list_->setCurrentIndex(again >= 0 && !is_new ? again : 0);
  showState();
}

void RecordingsCard::showState() {
  showWho();
  const bool open = study_.isOpen();
  hint_->setVisible(!open);
  into_->setVisible(!open);
  content_->setVisible(open);
  where_->setVisible(open && (!in_one_row_ || study_.isReadOnly()));
  if (open) {
    where_->setText(study_.isReadOnly() ? tr("%1 is open for reading only").arg(study_.fileName())
                                        : tr("Into the study %1").arg(study_.fileName()));
    content_->setToolTip(where_->text());
  }
  setVisible(open || roomy_);
  const bool replaying = store_.replayed().has_value();
  const bool recording = store_.isRecording();
  const bool any = !study_.recordings().empty();
  list_->setEnabled(any && !recording && !replaying);
  list_->setPlaceholderText(tr("none yet"));
  who_->setEnabled(!recording);
  record_->setEnabled(recording || (store_.canRecord() && !replaying));
  replay_->setEnabled(replaying || (any && !recording));
  replay_->setText(replaying ? tr("Stop") : tr("Replay"));
  replay_->setToolTip(replaying
                          ? tr("End the replay")
                          : tr("Let the recorded hand move the tool through the present model, by calculation; the "
                               "recorded force stands beside the present one in the trace"));
  record_->setIcon(recording ? recordIcon(feel_.isRunning()) : QIcon());
  if (!recording) {
    record_->setText(tr("Record"));
    record_->setToolTip(
        feel_.isRunning()
            ? tr("Record hand and force into the study, from a new placement on")
            : tr("Arm a recording: it begins with Start (F9), and goes into the study %1").arg(study_.fileName()));
  } else if (feel_.isRunning()) {
    record_->setText(tr("End · %1 s").arg(static_cast<int>(store_.recordedS())));
    record_->setToolTip(tr("End the recording"));
  } else {
    record_->setText(tr("Armed"));
    record_->setToolTip(tr("Cancel the recording, which begins with Start (F9)"));
  }
}

void RecordingsCard::setRoomy(bool roomy) {
  roomy_ = roomy;
  showState();
}

void RecordingsCard::chooseRecording() {
  list_->setFocus();
  list_->showPopup();
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
  if (const auto id = study::parseRecordId(list_->currentData().toString().toStdString())) store_.replay(*id);
}

MarksCard::MarksCard(FeelMarks& marks, FeelController& feel, QWidget* parent)
    : Card(parent),
      marks_(marks),
      feel_(feel),
      mark_(new QPushButton(tr("Mark this moment"), this)),
      list_(new QComboBox(this)) {
  mark_->setToolTip(tr("Keep the place, the speed, the conditions and the force that the hand feels now (F7)"));
  list_->setAccessibleName(tr("Marked moments"));
  list_->setToolTip(tr("Go to the place, the conditions and the force of a marked moment"));
  list_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  list_->setMinimumContentsLength(16);
  list_->setMaxVisibleItems(20);
  makeRow(this, {mark_, {list_, 1}}, theme::kGrid, inset(theme::kGrid));
  connect(mark_, &QPushButton::clicked, &marks_, &FeelMarks::mark);
  connect(list_, &QComboBox::activated, this, [this](int row) {
    list_->setCurrentIndex(-1);  // the same one can be chosen again
    marks_.returnTo(marks_.marks().size() - 1 - static_cast<std::size_t>(row));
  });
  connect(&marks_, &FeelMarks::changed, this, &MarksCard::list);
  connect(&feel_, &FeelController::stateChanged, this, &MarksCard::list);
  list();
}

// Newest first.
void MarksCard::list() {
  const auto& marks = marks_.marks();
  mark_->setEnabled(feel_.isRunning());
  list_->clear();
  for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
    const QDateTime when = QDateTime::fromMSecsSinceEpoch(mark->entry.when.utc_ms);
    list_->addItem(marks_.textOf(*mark) + QStringLiteral(" · ") + when.toString(QStringLiteral("yyyy-MM-dd HH:mm")));
  }
  list_->setPlaceholderText(marks.empty() ? tr("No moment is marked yet")
                                          : tr("Return to one of %n mark(s)", nullptr, static_cast<int>(marks.size())));
  list_->setCurrentIndex(-1);
  list_->setEnabled(!marks.empty());
}

}  // namespace tactus::workbench
