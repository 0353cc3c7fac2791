#include "app/workbench/views/device_bar.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/workbench/controllers/device_search.h"
#include "app/workbench/controllers/feel_controller.h"
#include "app/workbench/display_text.h"
#include "app/workbench/theme.h"
#include "app/workbench/views/card.h"

namespace tactus::workbench {
namespace {

void setInk(QLabel* label, const QColor& ink) {
  QPalette colors = label->palette();
  colors.setColor(QPalette::WindowText, ink);
  label->setPalette(colors);
}

QString ticksText(std::uint64_t ticks) {
  return ticks == 1 ? DeviceBar::tr("1 tick") : DeviceBar::tr("%1 ticks").arg(ticks);
}

}  // namespace

DeviceBar::DeviceBar(FeelController& feel, DeviceSearch& search, QWidget* parent)
    : QWidget(parent),
      feel_(feel),
      search_(search),
      devices_(new QComboBox(this)),
      look_(new QToolButton(this)),
      start_(new QPushButton(tr("Start"), this)),
      simulated_(new QLabel(tr("SIMULATED"), this)),
      state_(new QLabel(this)),
      message_card_(new Card(this)),
      message_(new QLabel(message_card_)),
      rearm_(new QPushButton(tr("Arm again"), message_card_)) {
  devices_->setAccessibleName(tr("Device"));
  devices_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  devices_->setMinimumContentsLength(14);
  look_->setText(tr("Search"));
  look_->setToolTip(tr("Look for haptic devices on this computer"));
  start_->setMinimumWidth(start_->fontMetrics().horizontalAdvance(tr("Start")) + 5 * theme::kGrid);
  start_->setFocusPolicy(Qt::TabFocus);
  QFont bold = theme::smallFont();
  bold.setBold(true);
  simulated_->setFont(bold);
  simulated_->setToolTip(tr("No hardware: hand, device and force are calculated"));
  setInk(simulated_, theme::warningInk());
  state_->setFont(theme::smallFont());
  state_->setTextFormat(Qt::PlainText);
  state_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  message_->setWordWrap(true);

  auto* message_row = new QHBoxLayout(message_card_);
  message_row->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid);
  message_row->addWidget(message_, 1);
  message_row->addWidget(rearm_);
  auto* row = new QHBoxLayout;
  row->setSpacing(theme::kGrid);
  row->addWidget(devices_, 1);
  row->addWidget(look_);
  row->addWidget(start_);
  auto* state_row = new QHBoxLayout;
  state_row->setSpacing(theme::kGrid);
  state_row->addWidget(simulated_);
  state_row->addWidget(state_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(row);
  layout->addLayout(state_row);
  layout->addWidget(message_card_);

  connect(devices_, &QComboBox::currentIndexChanged, this, &DeviceBar::showState);
  connect(look_, &QToolButton::clicked, &search_, &DeviceSearch::search);
  connect(start_, &QPushButton::clicked, this, &DeviceBar::toggle);
  connect(rearm_, &QPushButton::clicked, &feel_, &FeelController::rearm);
  connect(&search_, &DeviceSearch::searching, this, &DeviceBar::showState);
  connect(&search_, &DeviceSearch::found, this, &DeviceBar::listDevices);
  connect(&feel_, &FeelController::stateChanged, this, &DeviceBar::showState);
  connect(&feel_, &FeelController::tripChanged, this, &DeviceBar::showState);
  listDevices();
}

void DeviceBar::setModelOpen(bool open) {
  model_open_ = open;
  showState();
}

void DeviceBar::showFailure(const QString& sentence) {
  failure_ = sentence;
  showState();
}

void DeviceBar::showProgress() {
  const QString line = stateText();
  if (line != state_->text()) state_->setText(line);
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
  devices_->setEnabled(!running);
  look_->setEnabled(!running && !search_.isSearching());
  look_->setText(search_.isSearching() ? tr("Searching…") : tr("Search"));
  start_->setText(running ? tr("Stop") : tr("Start"));
  start_->setEnabled(running || model_open_);
  start_->setToolTip(running ? tr("No force from the next tick on (Esc)") : tr("Feel the open model"));
  const auto& list = search_.list().devices;
  const auto chosen = static_cast<std::size_t>(devices_->currentIndex());
  simulated_->setVisible(feel_.isReplay() || (chosen < list.size() && list[chosen].simulated));
  showProgress();

  if (const auto trip = feel_.trip()) {
    setMessage(
        tr("%1 (%2). No force until you arm again.").arg(trip->sentence, trip->at.toString(QStringLiteral("HH:mm:ss"))),
        true);
  } else if (!failure_.isEmpty()) {
    setMessage(failure_, true);
  } else {
    QStringList notes;
    for (const std::string& note : search_.list().notes) notes << text(note);
    setMessage(running ? QString() : notes.join(QLatin1Char('\n')), false);
  }
  rearm_->setVisible(feel_.trip().has_value());
  rearm_->setEnabled(feel_.state() == FeelState::kTripped);
}

void DeviceBar::setMessage(const QString& sentence, bool bad) {
  message_card_->setVisible(!sentence.isEmpty());
  message_->setText(sentence);
  message_card_->setColors(bad ? theme::errorFill() : theme::warningFill(),
                           bad ? theme::errorFill() : theme::warningFill());
  setInk(message_, bad ? theme::errorInk() : theme::warningInk());
}

QString DeviceBar::stateText() const {
  switch (feel_.state()) {
    case FeelState::kStopped:
      return model_open_ ? tr("Stopped: nothing is computed.") : tr("Open a model to feel it.");
    case FeelState::kTripped:
      return tr("Tripped: no force.");
    case FeelState::kRearming:
      return tr("Let go of the tube, then it arms again.");
    case FeelState::kRunning:
      break;
  }
  QStringList parts{feel_.isReplay() ? tr("Replaying a recording") : tr("Running"), feel_.priorityText()};
  if (const auto latency = feel_.editLatency())
    parts << tr("edit felt after %1 (longest %2)")
                 .arg(ticksText(latency->last_ticks), numberText(static_cast<double>(latency->longest_ticks)));
  if (const auto missed = feel_.statistics().missed; missed > 0) parts << tr("%1 ticks late").arg(missed);
  return parts.join(QStringLiteral(" · "));
}

void DeviceBar::toggle() {
  failure_.clear();
  if (feel_.isRunning()) {
    feel_.stop();
  } else {
    feel_.start(devices_->currentData().toString());
  }
}

}  // namespace tactus::workbench
