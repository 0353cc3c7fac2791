#include "app/workbench/rehearsal/rehearsal.h"

#include <algorithm>
#include <utility>

#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/rehearsal/rehearsal_progress.h"

namespace tactus::workbench {
namespace {

constexpr int kWakeMs = 1;
// Between two chances of the screens to be painted and of the study to be written.
constexpr double kMostAtOnceMs = 480;
// Longer than any rest of a warm device; and the computer has had time to show a screen and to store an answer.
constexpr double kStillS = 900;
constexpr qint64 kStillMs = 60'000;

}  // namespace

Rehearsal::Rehearsal(const Parts& on, session::NurseTraits traits, std::uint64_t seed, double speed)
    : on_(on), hands_(on.window, on.look), nurse_(hands_, std::move(traits), seed), speed_(speed) {
  timer_.setInterval(kWakeMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Rehearsal::wake);
}

void Rehearsal::begin() {
  clock_.start();
  serial_since_.start();
  serial_since_s_ = nowS();
  timer_.start();
}

void Rehearsal::wake() {
  owed_ms_ = std::min(owed_ms_ + static_cast<double>(clock_.nsecsElapsed()) * 1e-6 * speed_, kMostAtOnceMs);
  clock_.start();
  while (owed_ms_ >= VirtualTime::kBeat) {
    owed_ms_ -= VirtualTime::kBeat;
    nurse_.notice(on_.course.state(), nowS());
    tell();
    nurse_.live(on_.course.state(), on_.device.latest(), nowS());
    on_.time.advance(on_.device, VirtualTime::kBeat);
    if (!nurse_.isDone() && !nurse_.isSentAway() && !standsStill()) continue;
    timer_.stop();
    if (nurse_.isDone()) {
      emit done();
    } else {
      emit stuck(nurse_.isSentAway() ? tr("The screens ended the session before the nurse was done.")
                                     : tr("Nothing has happened for fifteen minutes on the screen \"%1\".")
                                           .arg(on_.window.screen()->accessibleName()));
    }
    return;
  }
}

void Rehearsal::tell() {
  const ParticipantState& state = on_.course.state();
  const std::pair now(state.serial, state.failed);
  if (told_ == now) return;
  told_ = now;
  emit came(progressLine(state, on_.course.session().snapshot().get(), nurse_.memory()));
}

bool Rehearsal::standsStill() {
  if (const std::uint64_t serial = on_.course.state().serial; serial != serial_) {
    serial_ = serial;
    serial_since_s_ = nowS();
    serial_since_.start();
  }
  return nowS() - serial_since_s_ > kStillS && serial_since_.elapsed() > kStillMs;
}

}  // namespace tactus::workbench
