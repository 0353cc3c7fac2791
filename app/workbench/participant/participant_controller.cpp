#include "app/workbench/participant/participant_controller.h"

#include <algorithm>
#include <random>
#include <utility>

#include "app/workbench/participant/consent_text.h"
#include "app/workbench/participant/participant_steps.h"

namespace tactus::workbench {

void SpeedCapture::open(const experiments::StrokeSettings& settings) {
  capture_.emplace(settings);
  last_tick_.reset();
}

std::optional<session::CapturedStroke> SpeedCapture::add(std::span<const haptics::Sample> samples) {
  if (!capture_) return std::nullopt;
  for (const haptics::Sample& sample : samples) {
    if (!last_tick_) first_ns_ = sample.time_ns;
    if (last_tick_ && sample.tick != *last_tick_ + 1) capture_->gap();
    last_tick_ = sample.tick;
    capture_->add({static_cast<double>(sample.time_ns - first_ns_) * 1e-9, sample.position_mm});
    if (auto stroke = capture_->take()) {
      close();
      return stroke;
    }
  }
  return std::nullopt;
}

SpeedState::Note noteOf(experiments::StrokeVerdict verdict) {
  using experiments::StrokeVerdict;
  using Note = SpeedState::Note;
  switch (verdict) {
    case StrokeVerdict::kAccepted: return Note::kRecorded;
    case StrokeVerdict::kTooShort: return Note::kTooShort;
    case StrokeVerdict::kBackwards: return Note::kBackwards;
    case StrokeVerdict::kOutOfRange: return Note::kOutOfRange;
    case StrokeVerdict::kTooBrief:
    case StrokeVerdict::kInterrupted:
    case StrokeVerdict::kRejected: break;
  }
  return Note::kNotRecorded;
}

namespace {

constexpr std::uint32_t kFirstButton = 1;

double secondsBetween(std::int64_t from_ns, std::int64_t to_ns) { return static_cast<double>(to_ns - from_ns) * 1e-9; }

}  // namespace

std::optional<ButtonPress> DeviceButton::add(const haptics::Sample& sample) {
  const bool down = (sample.buttons & kFirstButton) != 0;
  if (!down_since_ns_) {
    if (!down) {
      if (!open_since_ns_) open_since_ns_ = sample.time_ns;
      return std::nullopt;
    }
    const bool settled = open_since_ns_ && secondsBetween(*open_since_ns_, sample.time_ns) >= kSettleS;
    down_since_ns_ = sample.time_ns;
    told_ = !settled;
    return std::nullopt;
  }
  const double down_s = secondsBetween(*down_since_ns_, sample.time_ns);
  if (down) {
    if (told_ || down_s < kHeldS) return std::nullopt;
    told_ = true;
    return ButtonPress::kHeld;
  }
  const bool tap = !told_ && down_s < kTapS;
  down_since_ns_.reset();
  // One tap may follow the other at once.
  if (!open_since_ns_) open_since_ns_ = sample.time_ns;
  return tap ? std::optional(ButtonPress::kTap) : std::nullopt;
}

void ScreenGate::painted(std::int64_t now_ns) {
  if (painted_) return;
  painted_ = true;
  painted_ns_ = free_ns_ = now_ns;
  let_go_ = !held_;
}

void ScreenGate::held(bool held, std::int64_t now_ns) {
  held_ = held;
  if (!painted_ || held || let_go_) return;
  let_go_ = true;
  free_ns_ = now_ns;
}

bool ScreenGate::takesInput(std::int64_t now_ns) const { return painted_ && let_go_ && now_ns - free_ns_ >= kSettleNs; }

using Screen = ParticipantScreen;

ParticipantController::ParticipantController(StudyConnection& study, DeviceSession& device, ParticipantPlan plan,
                                             std::function<study::Moment()> now, QObject* parent)
    : QObject(parent),
      study_(study),
      device_(device),
      plan_(std::move(plan)),
      now_(std::move(now)),
      proxy_(study, nullptr, now_),
      check_in_(study, proxy_, plan_),
      grip_before_(device.grip()),
      trial_(device),
      own_(std::make_unique<OwnModelTrial>(study, device, about().device_scale)),
      steps_(allSteps(*this)) {
  connect(&proxy_, &SessionProxy::changed, this, &ParticipantController::onProxy);
  connect(&proxy_, &SessionProxy::refused, this, &ParticipantController::onRefused);
  // Her own model is stored beside the session.
  connect(&study_, &StudyConnection::changed, this, [this] {
    if (state_.screen == Screen::kOwnModel) look();
  });
  connect(&check_in_, &CheckIn::changed, this, &ParticipantController::look);
  connect(&check_in_, &CheckIn::refused, this, &ParticipantController::refused);
  followOwnModel();
  connect(&device_, &DeviceSession::stateChanged, this, &ParticipantController::onDevice);
  connect(&device_, &DeviceSession::sampled, this, &ParticipantController::onSampled);
  connect(&device_, &DeviceSession::advanced, this, [this] {
    if (hasDevice()) emit handMoved(device_.latest().position_mm);
  });
  connect(&device_, &DeviceSession::failed, this, [this](const QString& sentence) {
    if (device_.user() != this) return;
    device_lost_ = true;
    onDevice();
    emit refused(sentence);
  });
  state_.procedure = plan_.settings.procedure;
  state_.languages = !plan_.languages.empty() ? plan_.languages : nurse::languagesOf(about());
  state_.language = state_.languages.front();
  look();
}

ParticipantController::~ParticipantController() {
  device_.disconnect(this);
  device_.setGrip(grip_before_);
}

ParticipantController::Step& ParticipantController::step() const {
  // The practice of a part is done as the part is.
  const bool practice = state_.screen == Screen::kPractice;
  return *steps_.at(practice ? (state_.feels_force ? Screen::kForce : Screen::kSpeed) : state_.screen);
}

void ParticipantController::look() {
  const Screen before = state_.screen;
  state_.screen = correcting_ ? Screen::kForce : screenOf(at(), passed_);
  state_.form = QString::fromStdString(at() != nullptr ? at()->settings->form : plan_.settings.form);
  state_.code = check_in_.code();
  state_.welcome = check_in_.welcome();
  state_.welcome.minutes = minutesOf(plan_);
  state_.paused = at() != nullptr && at()->paused && !paused_by_her_;
  if (at() != nullptr) state_.feels_force = correcting_ || at()->part == session::SessionPart::kForce;
  if (std::string now_asked = asked(); now_asked != asked_) {
    asked_ = std::move(now_asked);
    ++state_.serial;
    gate_.close();
    onAsked();
  }
  state_.saving = proxy_.isSlow();
  // Her own model is stored beside the session, before she feels it.
  const bool own_waits = state_.screen == Screen::kOwnModel && !study_.failure().isEmpty();
  state_.failed = own_waits || !proxy_.failure().isEmpty();
  state_.simulated = plan_.simulated || (device_.device() && device_.device()->simulated);
  state_.device = deviceStep();
  state_.armed = device_.user() == this && device_.state() != DeviceSession::State::kStopped;
  state_.virtual_device = device_.device() && device_.device()->backend == "virtual";
  state_.hold = holdMeans();
  state_.waits = HoldWait::kNot;
  if (at() != nullptr) {
    state_.part = static_cast<int>(at()->blocks_done) + 1;
    state_.parts = static_cast<int>(at()->settings->blocks.size());
  }
  state_.can_go_on = true;
  state_.can_go_back = false;
  if (state_.screen != before) state_.page = {};
  step().show(state_);
  noteCircumstances();
  // While an answer is being stored nothing else is answered.
  if (proxy_.isMovingOn() || state_.paused) state_.can_go_on = state_.can_go_back = false;
  emit changed();
}

// Something is asked on the same screen whose answer no key may give that is still down.
void ParticipantController::askAnew() {
  ++state_.serial;
  gate_.close();
}

// Everything that makes another question of it. Not the stages of one force: the hand goes through them by itself.
std::string ParticipantController::asked() const {
  std::string out = std::to_string(static_cast<int>(state_.screen)) + '/' +
                    std::to_string(static_cast<int>(state_.overlay)) + (state_.paused ? "/paused" : "");
  if (at() != nullptr) out += '/' + std::to_string(at()->step);
  if (correcting_) out += "/correcting";
  return out + '/' + step().question();
}

HoldMeans ParticipantController::holdMeans() const {
  const auto device = device_.device();
  if (!device || isHeldByKey(*device)) return HoldMeans::kMouse;
  switch (enableOf(*device, device_.grip()).kind) {
    case haptics::EnableKind::kPedal: return HoldMeans::kPedal;
    case haptics::EnableKind::kKey: return HoldMeans::kMouse;
    case haptics::EnableKind::kLatch: return HoldMeans::kLatch;
    case haptics::EnableKind::kButton: break;
  }
  return HoldMeans::kButton;
}

DeviceStep ParticipantController::deviceStep() const {
  using State = DeviceSession::State;
  if (device_lost_) return DeviceStep::kLost;
  if (device_.user() != this) return DeviceStep::kWait;
  switch (device_.state()) {
    case State::kTripped: return DeviceStep::kWrong;
    case State::kRearming: return DeviceStep::kRelease;
    case State::kRunning: return check_.step();
    case State::kStopped: return DeviceStep::kLost;
    case State::kOpening:
    case State::kStopping: break;
  }
  return DeviceStep::kWait;
}

void ParticipantController::painted(quint64 serial) {
  if (serial == state_.serial) gate_.painted(now_().monotonic_ns);
}

void ParticipantController::setInputHeld(bool held) { gate_.held(held, now_().monotonic_ns); }

void ParticipantController::usesMeans(session::InputMeans means) { means_ = means; }

bool ParticipantController::takesInput() const {
  return state_.overlay == ForceOffOverlay::kNone && !state_.paused && !proxy_.isMovingOn() &&
         gate_.takesInput(now_().monotonic_ns);
}

bool ParticipantController::takesOverlay() const {
  const bool asks = state_.overlay != ForceOffOverlay::kNone && state_.overlay != ForceOffOverlay::kLeaving;
  return asks && gate_.takesInput(now_().monotonic_ns);
}

void ParticipantController::setLanguage(const QString& language) {
  const auto& offered = state_.languages;
  if (language == state_.language || std::find(offered.begin(), offered.end(), language) == offered.end()) return;
  state_.language = language;
  if (at() != nullptr) proxy_.note(session::languageChosen(language.toStdString()));
  look();
}

void ParticipantController::setTextPercent(int percent) {
  if (percent == state_.text_percent) return;
  state_.text_percent = percent;
  if (at() != nullptr) proxy_.note(session::textSizeChosen(percent));
  look();
}

void ParticipantController::newHere() {
  if (state_.screen == Screen::kWelcome && takesInput()) check_in_.newHere(false);
}

void ParticipantController::teacherHere() {
  if (state_.screen == Screen::kWelcome && takesInput()) check_in_.newHere(true);
}

void ParticipantController::enterCode(const QString& code) {
  if (state_.screen == Screen::kWelcome && takesInput()) check_in_.enterCode(code);
}

void ParticipantController::sitDown(const QString& code) {
  if (state_.screen == Screen::kWelcome && !check_in_.isKnown()) check_in_.prepare(code);
}

void ParticipantController::sitDownAsTeacher() {
  if (state_.screen == Screen::kWelcome && !check_in_.isKnown()) check_in_.newHere(true);
}

void ParticipantController::decline() {
  if (state_.screen != Screen::kConsent || !takesInput()) return;
  passed_.stopped = true;
  state_.stop = StopReason::kNoConsent;
  look();
}

void ParticipantController::next() {
  if (!takesInput() || !state_.can_go_on) return;
  step().next();
  if (std::exchange(ended_, false)) startAgain();
  look();
}

void ParticipantController::back() {
  if (!takesInput() || !state_.can_go_back) return;
  step().back();
  look();
}

void ParticipantController::choose(const QString& id) {
  if (!takesInput()) return;
  step().choose(id);
  look();
}

void ParticipantController::feelAgain() {
  if (!takesInput() || !trial_.wasPushed()) return;
  trial_.feelAgain();
  look();
}

void ParticipantController::lightNext() {
  const bool asks = correcting_ || trial_.wasPushed();
  if (!asks || !takesInput()) return;
  lit_.next(forceAnswers(), chance_);
  look();
}

void ParticipantController::answerLit() {
  if (lit_.id().isEmpty()) return;
  choose(lit_.id());
  next();
}

void ParticipantController::changeItem(int item) {
  if (state_.screen != Screen::kReview || !takesInput()) return;
  from_review_ = proxy_.goTo(at()->step, item);
}

void ParticipantController::mark() {
  if (state_.screen != Screen::kOwnModel || !own_->isThere() || !takesInput()) return;
  proxy_.note(own_->mark());
  look();
}

void ParticipantController::pause() {
  if (state_.armed) return forceOff();
  if (state_.overlay != ForceOffOverlay::kNone || state_.screen == Screen::kStopped) return;
  state_.overlay = ForceOffOverlay::kForceOff;
  state_.quiet_pause = true;
  if (at() != nullptr && !at()->paused && at()->part != session::SessionPart::kAborted) {
    paused_by_her_ = true;
    proxy_.pause(session::kPausedByHer);
  }
  look();
}

void ParticipantController::setMonitored(bool monitored) {
  state_.monitored = monitored;
  look();
}

void ParticipantController::acknowledgeCall() {
  if (state_.overlay != ForceOffOverlay::kCalled) return;
  state_.call_seen = true;
  if (at() != nullptr) proxy_.note({session::kCallSeen, {}});
  look();
}

void ParticipantController::forceOff() {
  giveNoForce();
  step().close();
  if (state_.overlay != ForceOffOverlay::kNone || state_.screen == Screen::kStopped) return;
  state_.overlay = ForceOffOverlay::kForceOff;
  state_.quiet_pause = false;
  if (at() != nullptr && !at()->paused && at()->part != session::SessionPart::kAborted) {
    paused_by_her_ = true;
    proxy_.pause(session::kForceOff);
  }
  if (at() != nullptr) proxy_.note({session::kForceOff, {}});
  look();
}

void ParticipantController::resume() {
  if (!takesOverlay()) return;
  state_.overlay = ForceOffOverlay::kNone;
  if (paused_by_her_) proxy_.unpause();
  look();
}

void ParticipantController::callResearcher() {
  if (!takesOverlay()) return;
  state_.overlay = ForceOffOverlay::kCalled;
  state_.call_seen = false;
  if (at() != nullptr) proxy_.note({session::kResearcherCalled, {}});
  look();
}

void ParticipantController::stopForToday() {
  if (!takesOverlay()) return;
  leaveFor(StopReason::kForToday);
}

void ParticipantController::askWithdraw() {
  if (!takesOverlay()) return;
  state_.overlay = ForceOffOverlay::kWithdraw;
  look();
}

void ParticipantController::keepData() {
  if (!takesOverlay()) return;
  state_.overlay = ForceOffOverlay::kForceOff;
  look();
}

void ParticipantController::withdraw() {
  if (!takesOverlay() || state_.overlay != ForceOffOverlay::kWithdraw) return;
  leaveFor(StopReason::kWithdrawn);
}

}  // namespace tactus::workbench
