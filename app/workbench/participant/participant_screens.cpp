// What the nurse's screens show: the state of ParticipantController.
#include <utility>

#include "app/workbench/participant/consent_text.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/questions.h"

namespace tactus::workbench {

using Screen = ParticipantScreen;

void ParticipantController::look() {
  state_.screen = correcting_ ? Screen::kForce : screenOf(at(), passed_);
  state_.code = arrival_.code();
  state_.welcome = arrival_.welcome();
  state_.welcome.minutes = minutesOf(plan_);
  state_.paused = at() != nullptr && at()->paused && !paused_by_her_;
  if (std::string now_asked = asked(); now_asked != asked_) {
    asked_ = std::move(now_asked);
    ++state_.serial;
    gate_.close();
    onAsked();
  }
  fill();
  emit changed();
}

// Everything that makes another question of it. Not the stages of one force: the hand goes through them by itself.
std::string ParticipantController::asked() const {
  std::string out = std::to_string(static_cast<int>(state_.screen)) + '/' +
                    std::to_string(static_cast<int>(state_.overlay)) + '/' +
                    std::to_string(static_cast<int>(state_.welcome.step)) + (state_.paused ? "/paused" : "");
  if (at() != nullptr) out += '/' + std::to_string(at()->step);
  if (state_.screen == Screen::kAboutYou) out += '/' + std::to_string(static_cast<int>(about_.state().question));
  if (state_.screen == Screen::kRating) out += rating_.isFirst() ? "/effort" : "/comfort";
  if (state_.screen == Screen::kOwnModel) out += '/' + std::to_string(own_->region());
  if (correcting_) out += "/correcting";
  return out;
}

void ParticipantController::fill() {
  state_.saving = proxy_.isSlow();
  // Her own model is stored beside the session, before she feels it.
  const bool own_waits = state_.screen == Screen::kOwnModel && !study_.failure().isEmpty();
  state_.failed = own_waits || !proxy_.failure().isEmpty();
  state_.simulated = plan_.simulated || (device_.device() && device_.device()->simulated);
  state_.device = deviceStep();
  if (at() != nullptr) {
    state_.part = static_cast<int>(at()->blocks_done) + 1;
    state_.parts = static_cast<int>(at()->settings->blocks.size());
  }
  state_.can_go_on = true;
  state_.can_go_back = false;
  switch (state_.screen) {
    case Screen::kWelcome: state_.can_go_on = state_.can_go_back = arrival_.isKnown(); break;
    case Screen::kConsent: {
      const nurse::Language language = nurse::languageWithId(state_.language).value_or(nurse::Language::kEnglish);
      state_.consent = {plan_.consent_version, consentParagraphs(plan_, language, arrival_.isForUsability()),
                        arrival_.isForUsability()};
      state_.can_go_back = true;
      break;
    }
    case Screen::kAboutYou:
      state_.about = about_.state();
      state_.can_go_on = about_.isAnswered();
      state_.can_go_back = !about_.isFirst();
      break;
    case Screen::kDeviceCheck:
      state_.can_go_on = state_.device == DeviceStep::kReady || state_.device == DeviceStep::kWrong ||
                         state_.device == DeviceStep::kLost;
      break;
    case Screen::kPractice:
    case Screen::kSpeed:
    case Screen::kForce:
      state_.feels_force = correcting_ || at()->part == session::SessionPart::kForce;
      state_.feels_force ? fillForce() : fillSpeed();
      break;
    case Screen::kQuestion: fillQuestion(); break;
    case Screen::kReview:
      if (form_) state_.review = reviewState(*form_, at()->replies);
      state_.review.sealed = at()->part == session::SessionPart::kFinished;
      break;
    case Screen::kRating:
    case Screen::kScale: fillScale(); break;
    case Screen::kOwnModel:
      state_.own = own_->state(hasDevice());
      state_.own.chosen = chosen_;
      state_.can_go_on = !state_.own.unavailable.isEmpty() || (state_.own.ready && !chosen_.isEmpty());
      break;
    case Screen::kThanks: state_.thanks.curve = own_->curve(); break;
    case Screen::kRest: state_.can_go_back = at()->judged.has_value(); break;
    case Screen::kGlossary:
    case Screen::kStopped: break;
  }
  // While an answer is being stored nothing else is answered.
  if (proxy_.isMovingOn() || state_.paused) state_.can_go_on = state_.can_go_back = false;
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

void ParticipantController::fillSpeed() {
  using Note = SpeedState::Note;
  const experiments::SpeedPlan& plan = *at()->speed;
  state_.speed.level = QString::fromStdString(plan.level);
  state_.speed.recorded = plan.number - 1;
  state_.speed.wanted = plan.count;
  state_.speed.note = !at_start_ && capture_note_ == Note::kStart ? Note::kReturn : capture_note_;
  state_.can_go_on = false;  // the hand does
}

void ParticipantController::fillForce() {
  ForceState out;
  out.asks = correcting_ || !at()->force->question.answers.empty();
  out.chosen = chosen_;
  out.lit = lit_.id();
  out.again = at()->force->attempt > 1;
  out.before = correcting_;
  switch (trial_.phase()) {
    case ForceTrial::Phase::kNone:
    case ForceTrial::Phase::kPause:
      out.phase = ForceState::Phase::kPause;
      out.warm = trial_.isWarm();
      break;
    case ForceTrial::Phase::kWait:
    case ForceTrial::Phase::kRise: out.phase = ForceState::Phase::kFeel; break;
    case ForceTrial::Phase::kFelt: out.phase = ForceState::Phase::kAnswer; break;
  }
  if (correcting_) out.phase = ForceState::Phase::kAnswer;
  state_.can_go_on = out.phase == ForceState::Phase::kAnswer && (!out.asks || !chosen_.isEmpty());
  state_.can_go_back = correcting_ || (out.asks && at()->judged);
  state_.force = std::move(out);
}

void ParticipantController::fillQuestion() {
  const ItemPage& page = *at()->page;
  if (form_) state_.question = questionState(*form_, page, chosen_);
  state_.question.from_review = from_review_;
  state_.can_go_on = !chosen_.isEmpty();
  state_.can_go_back = page.position > 1;
}

void ParticipantController::fillScale() {
  if (state_.screen == Screen::kRating) {
    state_.scale = rating_.state();
    state_.can_go_on = rating_.isAnswered();
    state_.can_go_back = !rating_.isFirst() || passed_.sealing || at()->judged;
    return;
  }
  state_.can_go_on = !chosen_.isEmpty();
  if (!at()->page) return;  // the last answer ends it
  const ItemPage& page = *at()->page;
  state_.scale = {QStringLiteral("u.%1").arg(page.item), static_cast<int>(page.position), static_cast<int>(page.count),
                  chosen_, false};
  state_.can_go_on = state_.can_go_on && at()->part == session::SessionPart::kForm;
  state_.can_go_back = page.position > 1;
}

}  // namespace tactus::workbench
