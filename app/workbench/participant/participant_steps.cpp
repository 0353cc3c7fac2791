// What ParticipantController does by itself: when another screen opens, an answer is stored, the hand moves.
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/consent_text.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/questions.h"

namespace tactus::workbench {
namespace {

using Screen = ParticipantScreen;

constexpr std::uint32_t kSecondButton = 2;  // of a stylus; the first one holds the tube

}  // namespace

void ParticipantController::onAsked() {
  chosen_.clear();
  lit_.reset();
  button_.reset();
  capture_.close();
  const bool over = state_.overlay != ForceOffOverlay::kNone || state_.paused;
  const bool feels = at() != nullptr && at()->part == session::SessionPart::kForce && !correcting_;
  if (!over && feels && (state_.screen == Screen::kForce || state_.screen == Screen::kPractice)) {
    trial_.begin(*at()->force);
    return;
  }
  giveNoForce();
  if (state_.screen != Screen::kRating && !correcting_) rating_.begin();
  if (over) return;
  const bool opens = device_.user() == this && device_.state() == DeviceSession::State::kOpening;
  if (correcting_) {
    chosen_ = wordOf(*at()->judged);
    return;
  }
  if (usesDevice(state_.screen) && !hasDevice() && !opens && !device_lost_) startDevice();
  if (state_.screen == Screen::kDeviceCheck) check_.begin();
  if (state_.screen == Screen::kQuestion) chosen_ = wordOf(at()->page->reply);
  if (state_.screen == Screen::kScale && at()->page && at()->page->reply) {
    chosen_ = QString::fromStdString(at()->page->reply->value);
  }
  if (state_.screen == Screen::kReview) from_review_ = false;
  if (state_.screen == Screen::kThanks || state_.screen == Screen::kStopped) stopDevice();
  if (state_.screen == Screen::kOwnModel) feelOwnModel();
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
  form_ = formWithConditions(at()->settings->form);
  if (const QString language = std::exchange(consent_language_, {}); !language.isEmpty()) {
    proxy_.note(session::consentGiven(at()->record->consent_version, language.toStdString(),
                                      std::exchange(consent_text_, {}).toStdString()));
  }
  // She sat down again: the interrupted part is resumed.
  if (std::exchange(resumes_, false) && at()->paused) {
    paused_by_her_ = true;
    proxy_.unpause();
  }
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
  if (runs) device_lost_ = false;
  const bool stopped = device_.user() == this && device_.state() == DeviceSession::State::kStopped;
  if (stopped && std::exchange(restarts_, false)) {
    device_.start(plan_.device, {}, this);
    return;
  }
  if (!runs && std::exchange(passed_.device, false) && at() != nullptr && usesDevice(state_.screen)) {
    proxy_.note(session::deviceLost(device_.trip() ? device_.trip()->sentence.toStdString() : std::string()));
  }
  look();
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
    if (const auto press = button_.add(sample)) pressedOnDevice(*press);
  }
  if (state_.overlay != ForceOffOverlay::kNone || state_.paused) return;
  if (state_.screen == Screen::kDeviceCheck) {
    if (check_.add(samples)) look();
  } else if (state_.screen == Screen::kSpeed || (state_.screen == Screen::kPractice && !state_.feels_force)) {
    captureStroke(samples);
  } else if (state_.screen == Screen::kOwnModel) {
    own_->look(samples);
  } else if (trial_.phase() != ForceTrial::Phase::kNone && gate_.isSettled(now_().monotonic_ns)) {
    if (trial_.add(samples)) look();
  }
}

void ParticipantController::pressedOnDevice(ButtonPress press) {
  const auto before = std::exchange(means_, session::InputMeans::kDeviceButton);
  if (state_.screen == Screen::kOwnModel) {
    if (press == ButtonPress::kTap) mark();
  } else if (press == ButtonPress::kTap) {
    lightNext();
  } else {
    answerLit();
  }
  means_ = before;
}

void ParticipantController::captureStroke(std::span<const haptics::Sample> samples) {
  const session::SessionSettings& settings = *at()->settings;
  const bool was_at_start = std::exchange(at_start_, samples.back().position_mm <= settings.force.start_zone_mm);
  if (!capture_.isOpen() && at_start_ && !proxy_.isMovingOn() && gate_.isSettled(now_().monotonic_ns)) {
    capture_.open(settings.speed.stroke);
    capture_note_ = SpeedState::Note::kStart;
    look();
    return;
  }
  if (auto stroke = capture_.add(samples)) {
    capture_note_ = noteOf(stroke->stroke.verdict);
    proxy_.addStroke(at()->step, std::move(*stroke));
    look();
  } else if (at_start_ != was_at_start) {
    look();
  }
}

void ParticipantController::beginSession() {
  consent_language_ = state_.language;
  consent_text_ = consentText(state_.consent.paragraphs,
                              nurse::languageWithId(state_.language).value_or(nurse::Language::kEnglish));
  arrival_.begin(state_.language, plan_.seed ? *plan_.seed : chance_(), plan_.device.toStdString());
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

void ParticipantController::judge() {
  experiments::ForceAnswer answer = trial_.measured();
  std::optional<session::AnswerInput> input;
  if (const auto option = answerOf(chosen_)) {
    answer.kind = option->kind;
    if (option->kind == study::ForceJudgement::Kind::kTerm) answer.term = option->id;
    input = answerInput();
  }
  trial_.cancel();
  proxy_.judge(at()->step, answer, std::move(input));
}

void ParticipantController::correct() {
  if (chosen_ != wordOf(*at()->judged)) proxy_.correctJudgement(at()->step, *answerOf(chosen_), answerInput());
  correcting_ = false;
}

void ParticipantController::answerQuestion() {
  const SessionStep step = at()->step;
  const bool answered = at()->page->reply.has_value();
  if (answered && wordOf(at()->page->reply) == chosen_) {
    from_review_ ? proxy_.goOn(step) : proxy_.forward(step);
    return;
  }
  if (proxy_.reply(step, *replyOf(*form_, chosen_), responseS(), answerInput()) && !answered) ++replies_;
}

void ParticipantController::answerScale() {
  const auto& before = at()->page->reply;
  if (before && QString::fromStdString(before->value) == chosen_) {
    proxy_.forward(at()->step);
  } else {
    proxy_.reply(at()->step, {study::Answer::Status::kAnswered, chosen_.toStdString()}, responseS(), answerInput());
  }
}

void ParticipantController::rate() {
  const bool first = rating_.isFirst();
  const bool all = rating_.next();
  if (first && rating_.effort()) {
    proxy_.note(session::effortRated(std::string(name(*at()->block)), *rating_.effort()));
  }
  if (!all) return;
  const bool stored = rating_.effort() && rating_.comfort()
                          ? proxy_.rate(at()->step, *rating_.effort(), *rating_.comfort())
                          : proxy_.closeBlock(at()->step);
  if (stored && passed_.sealing) proxy_.note({session::kAnswersSealed, {}});
}

void ParticipantController::endRest() {
  passed_.rests.insert(restBefore(*at(), passed_));
  passed_.replies = 0;
  proxy_.note({session::kRested, {}});
}

void ParticipantController::review() {
  if (at()->part == session::SessionPart::kFinished) {
    passed_.sealed = true;
  } else {
    passed_.sealing = true;
  }
}

void ParticipantController::followOwnModel() {
  connect(own_.get(), &OwnModelTrial::changed, this, [this] {
    feelOwnModel();
    look();
  });
}

void ParticipantController::feelOwnModel() {
  const bool here = state_.screen == Screen::kOwnModel && state_.overlay == ForceOffOverlay::kNone;
  if (here && !own_->isThere()) own_->prepare(arrival_.person()->code);
  if (here && own_->isThere() && hasDevice()) own_->feel();
}

void ParticipantController::goOnOwnModel() {
  if (own_->isThere()) proxy_.note(own_->say(chosen_));
  passed_.own_model = !own_->isThere() || own_->isDone();
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
  const bool in_study = at() != nullptr || !arrival_.isNewcomer();
  proxy_.leave();
  const auto leave = [this, reason] {
    state_.overlay = ForceOffOverlay::kNone;
    state_.stop = reason;
    passed_.stopped = true;
    paused_by_her_ = false;
    look();
  };
  if (reason != StopReason::kWithdrawn || !in_study || !arrival_.isKnown()) {
    leave();
    return;
  }
  study_.withdraw(arrival_.person()->id, leave, [this](const QString& sentence) {
    state_.overlay = ForceOffOverlay::kForceOff;
    onRefused(sentence);
  });
}

void ParticipantController::startAgain() {
  proxy_.leave();
  passed_ = {};
  met_ = correcting_ = false;
  replies_ = 0;
  about_ = {};
  form_.reset();
  own_ = std::make_unique<OwnModelTrial>(study_, device_);
  followOwnModel();
  capture_note_ = SpeedState::Note::kStart;
  const ParticipantState before = std::exchange(state_, {});
  state_.serial = before.serial;
  state_.languages = before.languages;
  state_.language = before.language;
  state_.text_percent = before.text_percent;
  arrival_.forget();
}

}  // namespace tactus::workbench
