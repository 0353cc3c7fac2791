#include "app/workbench/participant/participant_controller.h"

#include <algorithm>
#include <random>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/questions.h"

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
      arrival_(study, proxy_, plan_),
      trial_(device),
      own_(std::make_unique<OwnModelTrial>(study, device)) {
  connect(&proxy_, &SessionProxy::changed, this, &ParticipantController::onProxy);
  connect(&proxy_, &SessionProxy::refused, this, &ParticipantController::onRefused);
  connect(&arrival_, &Arrival::changed, this, &ParticipantController::look);
  connect(&arrival_, &Arrival::refused, this, &ParticipantController::refused);
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
  if (!plan_.languages.empty()) {
    state_.languages = plan_.languages;
    state_.language = plan_.languages.front();
  }
  look();
}

ParticipantController::~ParticipantController() = default;

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
  if (state_.screen == Screen::kWelcome && takesInput()) arrival_.newHere(false);
}

void ParticipantController::teacherHere() {
  if (state_.screen == Screen::kWelcome && takesInput()) arrival_.newHere(true);
}

void ParticipantController::enterCode(const QString& code) {
  if (state_.screen == Screen::kWelcome && takesInput()) arrival_.enterCode(code);
}

void ParticipantController::sitDown(const QString& code) {
  if (state_.screen == Screen::kWelcome && !arrival_.isKnown()) arrival_.enterCode(code);
}

void ParticipantController::sitDownAsTeacher() {
  if (state_.screen == Screen::kWelcome && !arrival_.isKnown()) arrival_.newHere(true);
}

void ParticipantController::decline() {
  if (state_.screen != Screen::kConsent || !takesInput()) return;
  passed_.stopped = true;
  state_.stop = StopReason::kNoConsent;
  look();
}

void ParticipantController::next() {
  if (!takesInput() || !state_.can_go_on) return;
  switch (state_.screen) {
    case Screen::kWelcome:
      if (arrival_.hasSession()) {
        resumes_ = true;
        arrival_.resume();
      } else {
        passed_.code = true;
      }
      break;
    case Screen::kConsent: beginSession(); break;
    case Screen::kAboutYou:
      if (about_.isLast()) {
        proxy_.tell(at()->step, about_.profile(), about_.experience());
      } else {
        about_.next();
      }
      break;
    case Screen::kDeviceCheck:
      if (state_.device == DeviceStep::kReady) {
        passed_.device = true;
      } else {
        startDevice();
      }
      break;
    case Screen::kPractice:
    case Screen::kForce: correcting_ ? correct() : judge(); break;
    case Screen::kSpeed: break;  // the hand does
    case Screen::kRest: endRest(); break;
    case Screen::kGlossary: passed_.glossary = true; break;
    case Screen::kQuestion: answerQuestion(); break;
    case Screen::kScale: answerScale(); break;
    case Screen::kRating: rate(); break;
    case Screen::kReview: review(); break;
    case Screen::kOwnModel: goOnOwnModel(); break;
    case Screen::kThanks:
    case Screen::kStopped: startAgain(); break;
  }
  look();
}

void ParticipantController::back() {
  if (!takesInput() || !state_.can_go_back) return;
  switch (state_.screen) {
    case Screen::kWelcome: arrival_.forget(); break;
    case Screen::kConsent: passed_.code = false; break;
    case Screen::kAboutYou: about_.back(); break;
    case Screen::kForce:
    case Screen::kRest: correcting_ = !correcting_; break;
    case Screen::kRating:
      if (!rating_.isFirst()) {
        rating_.back();
      } else if (passed_.sealing) {
        passed_.sealing = false;
      } else {
        correcting_ = true;
      }
      break;
    case Screen::kScale: proxy_.back(at()->step); break;
    case Screen::kQuestion:
      from_review_ = false;
      proxy_.back(at()->step);
      break;
    default: break;
  }
  look();
}

void ParticipantController::choose(const QString& id) {
  if (!takesInput()) return;
  switch (state_.screen) {
    case Screen::kAboutYou: about_.choose(id); break;
    case Screen::kForce:
      if ((correcting_ || trial_.phase() == ForceTrial::Phase::kFelt) && answerOf(id)) chosen_ = id;
      break;
    case Screen::kRating: rating_.choose(id); break;
    case Screen::kScale:
      if (scalePoints(id)) chosen_ = id;
      break;
    case Screen::kQuestion:
      if (form_ && replyOf(*form_, id)) chosen_ = id;
      break;
    case Screen::kOwnModel:
      if (id == QLatin1String("lighter") || id == QLatin1String("right") || id == QLatin1String("heavier"))
        chosen_ = id;
      break;
    default: break;
  }
  look();
}

void ParticipantController::feelAgain() {
  if (!takesInput() || trial_.phase() != ForceTrial::Phase::kFelt) return;
  trial_.feelAgain();
  look();
}

void ParticipantController::lightNext() {
  const bool asks = state_.screen == Screen::kForce && (correcting_ || trial_.phase() == ForceTrial::Phase::kFelt);
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

void ParticipantController::forceOff() {
  giveNoForce();
  capture_.close();
  if (state_.overlay != ForceOffOverlay::kNone || state_.screen == Screen::kStopped) return;
  state_.overlay = ForceOffOverlay::kForceOff;
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
