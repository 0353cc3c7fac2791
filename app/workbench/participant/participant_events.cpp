// What ParticipantController does by itself: when another screen opens, an answer is stored, the hand moves; and what
// its steps share.
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/participant_steps.h"

namespace tactus::workbench {
namespace {

using Screen = ParticipantScreen;

constexpr std::uint32_t kSecondButton = 2;  // of a stylus; the first one holds the tube

}  // namespace

void ParticipantController::onAsked() {
  chosen_.clear();
  lit_.reset();
  button_.reset();
  step().close();
  const bool over = state_.overlay != ForceOffOverlay::kNone || state_.paused;
  if (!over && step().beginsForce()) return;
  giveNoForce();
  if (state_.screen != Screen::kRating && !correcting_) rating_.begin();
  if (over) return;
  const bool opens = device_.user() == this && device_.state() == DeviceSession::State::kOpening;
  if (!correcting_ && factsOf(state_.screen).uses_device && !hasDevice() && !opens && !device_lost_) startDevice();
  step().ask();
}

void ParticipantController::onProxy() {
  if (leaving_) {
    finishLeaving();
  } else if (at() != nullptr) {
    if (!std::exchange(met_, true)) meetSession();
    // An answer brings the next rest nearer once it is stored.
    if (!proxy_.isMovingOn()) passed_.replies += std::exchange(replies_, 0);
    if (at()->profile) state_.left_handed = at()->profile->handedness == "left";
    if (!at()->judged) correcting_ = false;
    goOnByItself();
    const bool goes_on = state_.overlay == ForceOffOverlay::kNone && !at()->paused && !proxy_.isSaving();
    if (goes_on) paused_by_her_ = false;
  }
  look();
}

// The first snapshot of a new or resumed session.
void ParticipantController::meetSession() {
  passed_.blocks = at()->blocks_done;
  noted_.reset();
  form_ = formWithConditions(about(), at()->settings->form);
  if (const QString language = std::exchange(consent_language_, {}); !language.isEmpty()) {
    proxy_.note(session::consentGiven(at()->record->consent_version, language.toStdString(),
                                      std::exchange(consent_text_, {}).toStdString()));
  }
  if (plan_.setup) proxy_.note(session::setupChecked(*plan_.setup));
  // She sat down again: the interrupted part is resumed.
  if (std::exchange(resumes_, false) && at()->paused) {
    paused_by_her_ = true;
    proxy_.unpause();
  }
}

// When she sits down, and when any of it changes.
void ParticipantController::noteCircumstances() {
  const bool may = at() != nullptr && !leaving_ && !resumes_ && !proxy_.isMovingOn();
  if (!may || at()->part == session::SessionPart::kAborted) return;
  session::Circumstances now{
      state_.language.toStdString(), state_.text_percent, plan_.device.toStdString(), {}, plan_.device_friction_n};
  if (noted_) {  // what is known of the device stays known between its runs
    now.calibrated_utc = noted_->calibrated_utc;
    now.friction_in_n = noted_->friction_in_n;
  }
  if (const auto& device = device_.device(); device && hasDevice()) {
    now.calibrated_utc = device->calibrated_utc;
    if (device->friction_in_n) now.friction_in_n = device->friction_in_n;
  }
  if (noted_ && *noted_ == now) return;
  noted_ = now;
  proxy_.note(session::circumstancesNoted(now));
}

// A teacher is asked nothing but the statements.
void ParticipantController::goOnByItself() {
  if (!isUsability(*at()) || proxy_.isMovingOn() || at()->paused) return;
  if (at()->part == session::SessionPart::kProfile) proxy_.tell(at()->step, {});
  if (at()->part == session::SessionPart::kRating && proxy_.closeBlock(at()->step)) {
    proxy_.note({session::kAnswersSealed, {}});
  }
}

void ParticipantController::onRefused(const QString& sentence) {
  emit refused(sentence);
  asked_.clear();  // the same is asked once more
  look();
}

void ParticipantController::onDevice() {
  const bool runs = hasDevice() && device_.state() == DeviceSession::State::kRunning;
  if (runs) {
    device_lost_ = false;
    takeGrip();
  }
  const bool stopped = device_.user() == this && device_.state() == DeviceSession::State::kStopped;
  if (stopped && std::exchange(restarts_, false)) {
    device_.start(plan_.device, {}, this);
    return;
  }
  if (!runs && std::exchange(passed_.device, false) && at() != nullptr && factsOf(state_.screen).uses_device) {
    proxy_.note(session::deviceLost(device_.trip() ? device_.trip()->sentence.toStdString() : std::string()));
  }
  look();
}

// As the protocol says, whatever the researcher felt with. A key or the mouse is always kept down.
void ParticipantController::takeGrip() {
  const session::SessionSettings& settings = at() != nullptr ? *at()->settings : plan_.settings;
  DeviceGrip grip = device_.grip();
  grip.latch = settings.grip == session::Grip::kLatch && !isHeldByKey(*device_.device());
  device_.setGrip(grip);
}

// A device that has tripped is opened anew: it may be another cable.
void ParticipantController::startDevice() {
  device_lost_ = false;
  restarts_ = hasDevice();
  if (restarts_) {
    device_.stop();
  } else {
    device_.start(plan_.device, {}, this);
  }
}

void ParticipantController::stopDevice() {
  if (device_.user() == this) device_.stop();
}

void ParticipantController::giveNoForce() {
  trial_.cancel();
  if (hasDevice()) device_.setForce({});
}

void ParticipantController::onSampled(std::span<const haptics::Sample> samples) {
  if (!hasDevice()) return;
  for (const haptics::Sample& sample : samples) {
    const std::uint32_t pressed = sample.buttons & ~std::exchange(buttons_, sample.buttons);
    if ((pressed & kSecondButton) != 0) forceOff();
    // Of a latch each press holds or lets go: it answers nothing.
    if (const auto press = button_.add(sample); press && !device_.grip().latch) {
      const auto before = std::exchange(means_, session::InputMeans::kDeviceButton);
      step().pressed(*press);
      means_ = before;
    }
  }
  if (state_.overlay != ForceOffOverlay::kNone || state_.paused) return;
  step().sampled(samples);
}

std::vector<experiments::ForceAnswerOption> ParticipantController::forceAnswers() const {
  if (!correcting_) return at()->force->question.answers;
  using Kind = study::ForceJudgement::Kind;
  std::vector<experiments::ForceAnswerOption> out;
  for (const std::string& term : at()->settings->force.terms) out.push_back({Kind::kTerm, term, false});
  out.push_back({Kind::kNotFelt, "not_felt", true});
  out.push_back({Kind::kBeyondPractice, "beyond_practice", true});
  return out;
}

std::optional<experiments::ForceAnswerOption> ParticipantController::answerOf(const QString& id) const {
  for (const experiments::ForceAnswerOption& option : forceAnswers()) {
    if (id == QString::fromStdString(option.id)) return option;
  }
  return std::nullopt;
}

// With the button of the device: the word that it lit first, and the presses.
std::optional<session::AnswerInput> ParticipantController::answerInput() const {
  if (lit_.presses() > 0 && chosen_ == lit_.id()) {
    return session::AnswerInput{session::InputMeans::kDeviceButton, lit_.firstWord(), lit_.presses()};
  }
  return means_ ? std::optional(session::AnswerInput{*means_, {}, 0}) : std::nullopt;
}

double ParticipantController::responseS() const {
  return static_cast<double>(now_().monotonic_ns - gate_.paintedNs()) * 1e-9;
}

void ParticipantController::followOwnModel() {
  connect(own_.get(), &OwnModelTrial::changed, this, [this] {
    feelOwnModel();
    look();
  });
}

void ParticipantController::feelOwnModel() {
  const bool here = state_.screen == Screen::kOwnModel && state_.overlay == ForceOffOverlay::kNone;
  if (here && !own_->isThere()) own_->prepare(check_in_.person()->code);
  if (here && own_->isThere() && hasDevice()) own_->feel();
}

void ParticipantController::leaveFor(StopReason reason) {
  state_.overlay = ForceOffOverlay::kLeaving;
  leaving_ = reason;
  stopDevice();
  finishLeaving();
  look();
}

// The last answer is stored first.
void ParticipantController::finishLeaving() {
  if (!leaving_ || proxy_.isSaving()) return;
  const StopReason reason = *std::exchange(leaving_, std::nullopt);
  const bool in_study = at() != nullptr || !check_in_.isNewcomer();
  proxy_.leave();
  const auto leave = [this, reason] {
    state_.overlay = ForceOffOverlay::kNone;
    state_.stop = reason;
    passed_.stopped = true;
    paused_by_her_ = false;
    look();
  };
  if (reason != StopReason::kWithdrawn || !in_study || !check_in_.isKnown()) {
    leave();
    return;
  }
  study_.withdraw(check_in_.person()->id, leave, [this](const QString& sentence) {
    state_.overlay = ForceOffOverlay::kForceOff;
    onRefused(sentence);
  });
}

void ParticipantController::startAgain() {
  proxy_.leave();
  passed_ = {};
  met_ = correcting_ = false;
  replies_ = 0;
  form_.reset();
  own_ = std::make_unique<OwnModelTrial>(study_, device_, about().device_scale);
  followOwnModel();
  steps_ = allSteps(*this);
  const ParticipantState before = std::exchange(state_, {});
  state_.serial = before.serial;
  state_.procedure = before.procedure;
  state_.languages = before.languages;
  state_.language = before.language;
  state_.text_percent = before.text_percent;
  state_.monitored = before.monitored;
  // Who was prepared by the researcher is the only one of this session.
  const QString prepared = check_in_.isPrepared() ? check_in_.code() : QString();
  check_in_.forget();
  if (!prepared.isEmpty()) check_in_.prepare(prepared);
}

}  // namespace tactus::workbench
