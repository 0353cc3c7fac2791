#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/device/device_search.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"

namespace tactus::workbench {
namespace {

constexpr double kFarthestZoneMm = -100;
constexpr double kNearestZoneMm = -5;  // nearer, the end of a stroke would let go
constexpr int kOneLine = 520;          // px: below it the state has a line of its own

QString ticksText(std::uint64_t ticks) { return DeviceBar::tr("%n tick(s)", nullptr, static_cast<int>(ticks)); }

}  // namespace

DeviceBar::DeviceBar(FeelController& feel, DeviceSearch& search, QWidget* parent)
    : QWidget(parent),
      feel_(feel),
      search_(search),
      devices_(new QComboBox(this)),
      look_(new QToolButton(this)),
      chip_(new QToolButton(this)),
      start_(new QPushButton(tr("Start"), this)),
      grip_(new QComboBox(this)),
      zone_(new NumberBox({"release_zone", {}, "mm", kFarthestZoneMm, kNearestZoneMm, {}}, 1, this)),
      simulated_(new QLabel(tr("SIMULATED"), this)),
      state_(new ElidedLabel(this)),
      message_card_(new Card(this)),
      message_(new WrappedLabel(message_card_)),
      rearm_(new QPushButton(tr("Arm again"), message_card_)),
      again_(new QPushButton(tr("Try again"), message_card_)) {
  devices_->setAccessibleName(tr("Device"));
  devices_->setToolTip(tr("Choose the device on which the model is felt"));
  devices_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  // With large text in a small panel its end gives way.
  devices_->setMinimumWidth(12 * theme::kGrid);
  look_->setText(tr("Search"));
  look_->setToolTip(tr("Look for haptic devices on this computer"));
  chip_->setCheckable(true);
  chip_->setArrowType(Qt::DownArrow);
  chip_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  chip_->setToolTip(tr("Show the device and how the tool is held"));
  keepFitted(*start_, [this] {
    start_->setMinimumWidth(start_->fontMetrics().horizontalAdvance(tr("Stopping…")) + 2 * theme::kGrid);
  });
  start_->setFocusPolicy(Qt::TabFocus);
  grip_->setAccessibleName(tr("How to hold the tool"));
  grip_->setFocusPolicy(Qt::TabFocus);
  grip_->addItem(tr("Hold"));
  grip_->addItem(tr("Latch"));
  keepFitted(*grip_, [this] {
    grip_->setMinimumWidth(grip_->fontMetrics().horizontalAdvance(tr("Latch")) + 5 * theme::kGrid);
  });
  grip_->setItemData(0, tr("Hold the tool while the button of the device, the mouse button or Space is down"),
                     Qt::ToolTipRole);
  grip_->setItemData(1, tr("Press once to hold the tool, press again to release it. No need to squeeze"),
                     Qt::ToolTipRole);
  zone_->setWhole();
  zone_->setRoomFor(quantityText(kFarthestZoneMm, "mm", 0) + QLatin1Char(' '));
  zone_->setAccessibleName(tr("Release zone of the latch"));
  zone_->setToolTip(tr("Set the release zone: a hand that is drawn out further than this lets go"));
  QFont bold = theme::smallFont();
  bold.setBold(true);
  simulated_->setFont(bold);
  simulated_->setToolTip(tr("No hardware: hand, device and force are calculated"));
  setInk(*simulated_, theme::warningInk());
  state_->setFont(theme::smallFont());

  makeRow(message_card_, {{message_, 1}, rearm_, again_}, kStyleGap, inset(theme::kGrid, 4));
  auto* choice = makeRow({});
  for (QWidget* part : std::initializer_list<QWidget*>{chip_, devices_, look_, start_, grip_, zone_})
    choice->addWidget(part);
  auto* state_row = makeRow({simulated_, {state_, 1}});
  line_ = new QBoxLayout(QBoxLayout::LeftToRight);
  line_->setSpacing(theme::kGrid);
  line_->addLayout(choice);
  line_->addLayout(state_row, 1);
  makeColumn(this, {line_, message_card_}, 4);

  connect(devices_, &QComboBox::currentIndexChanged, this, &DeviceBar::showState);
  connect(chip_, &QToolButton::toggled, this, &DeviceBar::showChoice);
  connect(look_, &QToolButton::clicked, &search_, &DeviceSearch::search);
  connect(start_, &QPushButton::clicked, this, &DeviceBar::toggle);
  connect(rearm_, &QPushButton::clicked, &feel_.session(), &DeviceSession::rearm);
  connect(again_, &QPushButton::clicked, this, &DeviceBar::toggle);
  connect(grip_, &QComboBox::activated, this, &DeviceBar::chooseGrip);
  connect(zone_, &NumberBox::valueChanged, this, &DeviceBar::chooseGrip);
  connect(&search_, &DeviceSearch::searching, this, &DeviceBar::showState);
  connect(&search_, &DeviceSearch::found, this, &DeviceBar::listDevices);
  connect(&feel_, &FeelController::stateChanged, this, &DeviceBar::showState);
  connect(&feel_.session(), &DeviceSession::tripChanged, this, &DeviceBar::showState);
  listDevices();
}

void DeviceBar::chooseGrip() { feel_.session().setGrip({grip_->currentIndex() == 1, zone_->value()}); }

void DeviceBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitLine();
  fitMessage();
}

// The state gives way to its end; the word SIMULATED does not.
void DeviceBar::fitLine() {
  const int choice = line_->itemAt(0)->minimumSize().width();
  const int least = choice + line_->spacing() + (simulated_->isHidden() ? 0 : simulated_->minimumSizeHint().width());
  const bool wraps = width() < std::max(kOneLine, least);
  const auto direction = wraps ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
  if (line_->direction() != direction) line_->setDirection(direction);
}

void DeviceBar::setModelOpen(bool open) {
  model_open_ = open;
  showState();
}

void DeviceBar::setFoldable(bool foldable) {
  if (foldable == foldable_) return;
  foldable_ = foldable;
  showChoice();
}

void DeviceBar::showChoice() {
  const bool folded = foldable_ && feel_.isRunning();
  const bool open = !folded || chip_->isChecked();
  chip_->setVisible(folded);
  chip_->setText(devices_->currentText() + QStringLiteral(" · ") + grip_->currentText());
  for (QWidget* part : std::initializer_list<QWidget*>{devices_, look_, grip_}) part->setVisible(open);
  zone_->setVisible(open && feel_.session().grip().latch);
  fitLine();
  if (!folded) chip_->setChecked(false);
}

void DeviceBar::showFailure(const QString& sentence) {
  failure_ = std::exchange(starting_, false) ? tr("The device did not start. %1").arg(sentence) : sentence;
  showState();
}

void DeviceBar::showProgress() {
  state_->setFullText(stateText(), stateWord());
  // Advice for the first stroke.
  if (advises_ && feel_.strokes() > 0) showMessage();
}

void DeviceBar::listDevices() {
  const QSignalBlocker no_signal(devices_);
  const QString chosen = devices_->currentData().toString();
  devices_->clear();
  auto* items = qobject_cast<QStandardItemModel*>(devices_->model());
  for (const devices::ListedDevice& device : search_.list().devices) {
    devices_->addItem(text(device.name), text(device.id));
    const int row = devices_->count() - 1;
    QString reason = text(device.reason);
    if (!device.advice.empty()) reason += (reason.isEmpty() ? QString() : QStringLiteral("; ")) + text(device.advice);
    devices_->setItemData(row, reason, Qt::ToolTipRole);
    if (!device.usable) items->item(row)->setEnabled(false);
  }
  const int again = devices_->findData(chosen);
  // The virtual device is the last one, and always usable.
  devices_->setCurrentIndex(again >= 0 ? again : devices_->count() - 1);
  showState();
}

void DeviceBar::showState() {
  const bool running = feel_.isRunning();
  if (running) starting_ = false;
  const bool opening = feel_.state() == FeelController::State::kOpening;
  const bool stopping = feel_.state() == FeelController::State::kStopping;
  const bool busy = running || opening || stopping;
  devices_->setEnabled(!busy);
  look_->setEnabled(!busy && !search_.isSearching());
  look_->setText(search_.isSearching() ? tr("Searching…") : tr("Search"));
  start_->setText(stopping ? tr("Stopping…") : running || opening ? tr("Stop") : tr("Start"));
  start_->setEnabled(!stopping && (busy || model_open_));
  start_->setToolTip(running ? tr("Stop the force with the next tick (F12, or Esc)") : tr("Feel the open model (F9)"));
  {
    const QSignalBlocker no_grip(grip_);
    const QSignalBlocker no_zone(zone_);
    grip_->setCurrentIndex(feel_.session().grip().latch ? 1 : 0);
    zone_->setValue(feel_.session().grip().release_zone_mm);
  }
  showChoice();
  grip_->setToolTip(grip_->currentData(Qt::ToolTipRole).toString());
  const auto& list = search_.list().devices;
  const auto chosen = static_cast<std::size_t>(devices_->currentIndex());
  simulated_->setVisible(feel_.isReplay() || (chosen < list.size() && list[chosen].simulated));
  showProgress();
  showMessage();
}

void DeviceBar::showMessage() {
  const bool running = feel_.isRunning();
  advises_ = false;
  rearm_->setVisible(running && feel_.session().trip());
  rearm_->setEnabled(feel_.state() == FeelController::State::kTripped);
  again_->setVisible(!failure_.isEmpty() && feel_.state() == FeelController::State::kStopped && model_open_);
  if (const auto trip = feel_.session().trip()) {
    // Of a run that has ended the cause stays said.
    const QString what = running ? tr("%1 (%2). No force until you arm again.") : tr("%1 (%2).");
    setMessage(what.arg(trip->sentence, trip->at.toString(QStringLiteral("HH:mm:ss"))), true);
  } else if (!failure_.isEmpty()) {
    setMessage(failure_, true);
  } else if (const QString advice = feel_.session().axisAdvice(); !advice.isEmpty() && feel_.strokes() == 0) {
    advises_ = true;
    setMessage(tr("If pushing in pulls out: %1").arg(advice), false);
  } else {
    QStringList notes;
    for (const std::string& note : search_.list().notes) notes << text(note);
    setMessage(running ? QString() : notes.join(QLatin1Char('\n')), false);
  }
}

void DeviceBar::fitMessage() {
  int room = width() - 2 * theme::kGrid;
  for (const QPushButton* button : {rearm_, again_}) {
    if (button->isVisibleTo(message_card_)) room -= button->sizeHint().width() + theme::kGrid;
  }
  message_->setFixedHeight(std::max(message_->heightForWidth(std::max(100, room)), message_->fontMetrics().height()));
}

void DeviceBar::setMessage(const QString& sentence, bool bad) {
  message_card_->setVisible(!sentence.isEmpty());
  message_->setText(sentence);
  fitMessage();
  message_card_->setColors(bad ? theme::errorFill() : theme::warningFill(),
                           bad ? theme::errorFill() : theme::warningFill());
  setInk(*message_, bad ? theme::errorInk() : theme::warningInk());
}

// Where there is little room.
QString DeviceBar::stateWord() const {
  switch (feel_.state()) {
    case FeelController::State::kStopped: return tr("Stopped");
    case FeelController::State::kOpening: return tr("Starting");
    case FeelController::State::kStopping: return tr("Stopping");
    case FeelController::State::kTripped: return tr("Tripped");
    case FeelController::State::kRearming: return tr("Let go");
    case FeelController::State::kRunning: break;
  }
  return feel_.isReplay() ? tr("Replay") : tr("Running");
}

QString DeviceBar::stateText() const {
  switch (feel_.state()) {
    case FeelController::State::kStopped:
      return model_open_ ? tr("Stopped: nothing is computed.") : tr("Open a model to feel it.");
    case FeelController::State::kOpening: return tr("Starting the device…");
    case FeelController::State::kStopping: return tr("No force. The device is stopping…");
    case FeelController::State::kTripped: return tr("Tripped: no force.");
    case FeelController::State::kRearming: return tr("Let go of the tool, then it arms again.");
    case FeelController::State::kRunning: break;
  }
  QStringList parts{feel_.isReplay() ? tr("Replaying a recording") : tr("Running"), feel_.session().priorityText()};
  if (const auto latency = feel_.editLatency())
    parts << tr("edit felt after %1 (longest %2)")
                 .arg(ticksText(latency->last_ticks), numberText(static_cast<double>(latency->longest_ticks)));
  const haptics::LoopStatistics statistics = feel_.session().statistics();
  if (statistics.missed > 0) parts << tr("%n force update(s) came late", nullptr, static_cast<int>(statistics.missed));
  if (statistics.restarts > 0)
    parts << tr("force begun anew after %n stall(s)", nullptr, static_cast<int>(statistics.restarts));
  return parts.join(QStringLiteral(" · "));
}

void DeviceBar::toggle() {
  failure_.clear();
  if (feel_.state() == FeelController::State::kStopped) {
    starting_ = true;
    feel_.start(devices_->currentData().toString());
  } else {
    starting_ = false;
    feel_.stop();
  }
}

}  // namespace tactus::workbench
