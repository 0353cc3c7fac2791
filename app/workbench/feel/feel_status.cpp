#include "app/workbench/feel/feel_status.h"

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/feel/feel_controller.h"

namespace tactus::workbench {

FeelStatus::FeelStatus(const FeelController& feel, QWidget* parent) : QLabel(parent), feel_(feel) {
  setTextFormat(Qt::PlainText);
  setFont(theme::smallFont());
  connect(&feel_, &FeelController::stateChanged, this, &FeelStatus::showState);
  connect(&feel_, &FeelController::advanced, this, &FeelStatus::showLatency);
  showState();
}

void FeelStatus::showState() {
  const auto device = feel_.device();
  const bool tripped = device && feel_.session().trip();
  setInk(*this, tripped ? theme::errorInk() : theme::mutedInk());
  if (!device) {
    setText(feel_.state() == FeelController::State::kOpening    ? tr("Feel: starting…")
            : feel_.state() == FeelController::State::kStopping ? tr("Feel: stopping…")
                                                                : tr("Feel: stopped"));
  } else {
    const QString name = device->simulated ? tr("simulated device") : workbench::text(device->name);
    setText(tripped ? tr("Feel: tripped, %1").arg(name) : tr("Feel: running, %1").arg(name));
  }
  showLatency();
}

void FeelStatus::showLatency() {
  QString latency;
  if (const auto felt = feel_.isRunning() ? feel_.editLatency() : std::nullopt) {
    latency = tr("felt after %n tick(s)", nullptr, static_cast<int>(felt->last_ticks));
  }
  if (latency == latency_) return;
  latency_ = latency;
  emit latencyChanged(latency);
}

}  // namespace tactus::workbench
