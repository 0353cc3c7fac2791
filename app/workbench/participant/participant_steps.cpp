// What ParticipantController does by itself: when another screen opens, an answer is stored, the hand moves.
#include <algorithm>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/questions.h"
#include "questionnaires/questionnaire.h"

namespace tactus::workbench {
namespace {

using Screen = ParticipantScreen;

constexpr std::uint32_t kSecondButton = 2;  // of a stylus; the first one holds the tube

std::string languageOf(const std::string& form, const QString& language) {
  const auto known = questionnaires::languagesOf(form);
  const std::string wanted = language.toStdString();
  return std::find(known.begin(), known.end(), wanted) == known.end() ? "en" : wanted;
}

}  // namespace

void ParticipantController::onAsked() {
  chosen_.clear();
  lit_.clear();
  lit_presses_ = 0;
  capture_.close();
  const bool over = state_.overlay != ForceOffOverlay::kNone || state_.paused;
  const bool feels = at() != nullptr && at()->part == session::SessionPart::kForce;
  if (!over && feels && (state_.screen == Screen::kForce || state_.screen == Screen::kPractice)) {
    trial_.begin(*at()->force);
    return;
  }
  giveNoForce();
  if (over) return;
  const bool opens = device_.user() == this && device_.state() == DeviceSession::State::kOpening;
  if (usesDevice(state_.screen) && !hasDevice() && !opens && !device_lost_) startDevice();
  if (state_.screen == Screen::kDeviceCheck) check_.begin();
  if (state_.screen == Screen::kQuestion) chosen_ = wordOf(at()->page->reply);
  if (state_.screen == Screen::kReview) from_review_ = false;
  if (state_.screen == Screen::kThanks || state_.screen == Screen::kStopped) stopDevice();
  if (state_.screen == Screen::kOwnModel) feelOwnModel();
}

void ParticipantController::onProxy() {
  if (leaving_) {
    finishLeaving();
  } else if (at() != nullptr) {
    if (const QString language = std::exchange(consent_language_, {}); !language.isEmpty()) {
      proxy_.note(session::consentGiven(at()->record->consent_version, language.toStdString()));
    }
    if (!form_) form_ = formWithConditions(at()->settings->form);
    if (at()->profile) state_.left_handed = at()->profile->handedness == "left";
    // She sat down again: what she stopped with goes on.
    if (std::exchange(resumes_, false) && at()->paused) {
      paused_by_her_ = true;
      proxy_.unpause();
    }
    const bool goes_on = state_.overlay == ForceOffOverlay::kNone && !at()->paused && !proxy_.isSaving();
    if (goes_on) paused_by_her_ = false;
  }
  look();
}

void ParticipantController::onRefused(const QString& sentence) {
  emit refused(sentence);
  asked_.clear();  // the same is asked once more
  look();
}

void ParticipantController::onDevice() {
  const bool runs = hasDevice() && device_.state() == DeviceSession::State::kRunning;
  if (runs) device_lost_ = false;
  if (!runs && std::exchange(passed_.device, false) && at() != nullptr && usesDevice(state_.screen)) {
    proxy_.note(session::deviceLost(device_.trip() ? device_.trip()->sentence.toStdString() : std::string()));
  }
  look();
}

void ParticipantController::startDevice() {
  device_lost_ = false;
  if (hasDevice() && device_.state() == DeviceSession::State::kTripped) {
    device_.rearm();
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
  }
  if (state_.overlay != ForceOffOverlay::kNone || state_.paused) return;
  if (state_.screen == Screen::kDeviceCheck) {
    if (check_.add(samples)) look();
  } else if (state_.screen == Screen::kSpeed || (state_.screen == Screen::kPractice && !state_.feels_force)) {
    captureStroke(samples);
  } else if (trial_.stage() != ForceTrial::Stage::kNone && gate_.isSettled(now_().monotonic_ns)) {
    if (trial_.add(samples)) look();
  }
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
  session::SessionStart start;
  start.person = person_->id;
  start.consent_version = plan_.consent_version.toStdString();
  start.seed = plan_.seed ? *plan_.seed : chance_();
  start.language = languageOf(plan_.settings.form, state_.language);
  start.station = plan_.station.toStdString();
  start.program = kGenerator;
  start.device = plan_.device.toStdString();
  start.device_friction_n = plan_.device_friction_n;
  start.settings = plan_.settings;
  start.protocol = plan_.protocol;
  consent_language_ = state_.language;
  proxy_.begin(start, newcomer_ ? person_ : std::nullopt);
}

void ParticipantController::tellProfile() { proxy_.tell(at()->step, about_.profile(), about_.experience()); }

std::optional<experiments::ForceAnswerOption> ParticipantController::answerOf(const QString& id) const {
  for (const experiments::ForceAnswerOption& option : at()->force->question.answers) {
    if (id == QString::fromStdString(option.id)) return option;
  }
  return std::nullopt;
}

// With the button of the device: the word that it lit first, and the presses.
std::optional<session::AnswerInput> ParticipantController::answerInput() const {
  if (lit_presses_ > 0 && chosen_ == lit_) {
    return session::AnswerInput{session::InputMeans::kDeviceButton, at()->force->question.answers[lit_first_].id,
                                lit_presses_};
  }
  return means_ ? std::optional(session::AnswerInput{*means_, {}, 0}) : std::nullopt;
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

void ParticipantController::answerQuestion() {
  const SessionStep step = at()->step;
  const bool answered = at()->page->reply.has_value();
  if (answered && wordOf(at()->page->reply) == chosen_) {
    from_review_ ? proxy_.goOn(step) : proxy_.forward(step);
    return;
  }
  const double response_s = static_cast<double>(now_().monotonic_ns - gate_.paintedNs()) * 1e-9;
  if (proxy_.reply(step, *replyOf(*form_, chosen_), response_s, answerInput()) && !answered) ++passed_.replies;
}

void ParticipantController::endRest() {
  passed_.rest = restBefore(*at(), passed_);
  passed_.replies = 0;
  proxy_.note({session::kRested, {}});
  if (at()->part == session::SessionPart::kRating) proxy_.closeBlock(at()->step);
}

void ParticipantController::feelOwnModel() {
  if (own_ == nullptr || !hasDevice()) {
    if (own_ == nullptr && !std::exchange(own_asked_, true)) readOwnModel();
    return;
  }
  ForceOrders force;
  force.source = haptics::ForceSource::kInsertion;
  force.scene = own_->scene;
  force.placement = device_.newNumber();
  force.start_depth_mm = own_->regions[own_region_].from_mm - own_->depthOffsetMm();
  device_.setForce(force);
}

void ParticipantController::readOwnModel() {
  study_.read(*this, [this, code = person_->code](const store::StudyFile& file) -> StudyConnection::Deliver {
    auto model = std::make_shared<base::Result<OwnModel>>(ownModel(file, code));
    return [this, model] {
      if (*model) {
        own_ = std::make_shared<const OwnModel>(std::move(**model));
        if (state_.screen == Screen::kOwnModel && state_.overlay == ForceOffOverlay::kNone) feelOwnModel();
      } else {
        own_refused_ = text(model->error().message());
      }
      look();
    };
  });
}

session::OwnModelPlace ParticipantController::ownModelPlace() const {
  const haptics::Sample& sample = device_.latest();
  return {std::nullopt, own_->regions[own_region_].id, sample.depth_mm + own_->depthOffsetMm(), sample.force_n};
}

void ParticipantController::goOnOwnModel() {
  if (own_ != nullptr) {
    using session::OwnModelVerdict;
    const auto verdict = chosen_ == QLatin1String("lighter")   ? OwnModelVerdict::kLighter
                         : chosen_ == QLatin1String("heavier") ? OwnModelVerdict::kHeavier
                                                               : OwnModelVerdict::kAboutRight;
    proxy_.note(session::ownModelVerdict({std::nullopt, own_->regions[own_region_].id, {}, {}}, verdict));
    own_marks_ = 0;
    if (++own_region_ < own_->regions.size()) return;
    own_region_ = 0;
  }
  passed_.own_model = true;
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
  const bool in_study = at() != nullptr || !newcomer_;
  proxy_.leave();
  const auto leave = [this, reason] {
    state_.overlay = ForceOffOverlay::kNone;
    state_.stop = reason;
    passed_.stopped = true;
    paused_by_her_ = false;
    look();
  };
  if (reason != StopReason::kWithdrawn || !in_study || !person_) {
    leave();
    return;
  }
  study_.withdraw(person_->id, leave, [this](const QString& sentence) {
    state_.overlay = ForceOffOverlay::kForceOff;
    onRefused(sentence);
  });
}

void ParticipantController::startAgain() {
  proxy_.leave();
  passed_ = {};
  person_.reset();
  earlier_session_.reset();
  about_ = {};
  form_.reset();
  own_.reset();
  own_refused_.clear();
  own_asked_ = false;
  own_region_ = 0;
  own_marks_ = 0;
  capture_note_ = SpeedState::Note::kStart;
  const ParticipantState before = std::exchange(state_, {});
  state_.serial = before.serial;
  state_.language = before.language;
  state_.text_percent = before.text_percent;
}

}  // namespace tactus::workbench
