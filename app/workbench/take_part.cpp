#include "app/workbench/take_part.h"

#include <QPointer>
#include <utility>

#include "app/workbench/participant/participant_window.h"
#include "core/store/research_key.h"

namespace tactus::workbench {

TakePart::TakePart(StudyConnection& study, DeviceSession& device, const ParticipantPlan& plan,
                   std::function<study::Moment()> now)
    : study_(study),
      course_(study, device, plan, std::move(now)),
      window_(look_, [&device] { device.setForce({}); }),
      views_(course_, look_, window_),
      hand_(window_, look_, device) {
  connect(&course_, &ParticipantController::changed, this, &TakePart::giveHand);
  connect(&views_, &ParticipantViews::finished, this, &TakePart::finished);
  connect(&window_, &ParticipantWindow::forceOff, this, [this](ForceOffCause cause) {
    // In a pause of the researcher, who types in the monitor, there is no force, and nothing to ask the participant.
    if (cause == ForceOffCause::kDeactivated && course_.state().paused) return;
    course_.forceOff();
  });
  connect(&window_, &ParticipantWindow::leaveAsked, this, &TakePart::askForPassphrase);
}

void TakePart::begin(QScreen& screen) { window_.showOn(screen); }

// On screens where she pushes and feels; elsewhere the keys choose and continue.
void TakePart::giveHand() {
  const ParticipantState& state = course_.state();
  using Screen = ParticipantScreen;
  const bool pushes = state.screen == Screen::kSpeed || state.screen == Screen::kOwnModel ||
                      (state.screen == Screen::kPractice && !state.feels_force) ||
                      (state.screen == Screen::kDeviceCheck && state.device != DeviceStep::kReady);
  const bool feels = (state.screen == Screen::kForce || state.screen == Screen::kPractice) && state.feels_force &&
                     state.force.phase != ForceState::Phase::kAnswer;
  const bool covered = state.overlay != ForceOffOverlay::kNone;
  hand_.setWanted(!covered && (pushes || feels));
  if (covered) hand_.letGo();
}

void TakePart::askForPassphrase() {
  auto* panel = new LeavePanel(look_);
  connect(panel, &LeavePanel::stay, &window_, &ParticipantWindow::endQuestion);
  connect(panel, &LeavePanel::entered, this, [this, panel](const QString& passphrase) { check(*panel, passphrase); });
  window_.askResearcher(panel);
}

void TakePart::check(LeavePanel& asked, const QString& passphrase) {
  study_.read(*this, [this, panel = QPointer(&asked), typed = passphrase.toStdString()](const store::StudyFile& file) {
    const auto opens = store::opensResearch(file, typed);
    return [this, panel, right = opens && *opens] {
      if (right) {
        window_.leave();
        emit left();
      } else if (panel) {
        panel->refuse();
      }
    };
  });
}

}  // namespace tactus::workbench
