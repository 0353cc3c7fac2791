#include "app/workbench/participant/shown_state.h"

namespace tactus::workbench {
namespace {

nurse::DeviceStep shownStep(DeviceStep step) {
  switch (step) {
    case DeviceStep::kWait: return nurse::DeviceStep::kWait;
    case DeviceStep::kHold: return nurse::DeviceStep::kHold;
    case DeviceStep::kStill: return nurse::DeviceStep::kStill;
    case DeviceStep::kPush: return nurse::DeviceStep::kPush;
    case DeviceStep::kRelease: return nurse::DeviceStep::kRelease;
    case DeviceStep::kReady: return nurse::DeviceStep::kReady;
    case DeviceStep::kWrong: return nurse::DeviceStep::kWrong;
    case DeviceStep::kLost: break;
  }
  return nurse::DeviceStep::kLost;
}

nurse::StrokeNote shownNote(SpeedState::Note note) {
  using Note = SpeedState::Note;
  switch (note) {
    case Note::kStart: return nurse::StrokeNote::kStart;
    case Note::kReturn: return nurse::StrokeNote::kReturn;
    case Note::kRecorded: return nurse::StrokeNote::kRecorded;
    case Note::kTooShort: return nurse::StrokeNote::kTooShort;
    case Note::kNotRecorded: return nurse::StrokeNote::kNotRecorded;
    case Note::kBackwards: return nurse::StrokeNote::kBackwards;
    case Note::kOutOfRange: break;
  }
  return nurse::StrokeNote::kOutOfRange;
}

nurse::SpeedWord shownSpeed(const QString& level) {
  if (level == QLatin1String("slow")) return nurse::SpeedWord::kSlow;
  return level == QLatin1String("fast") ? nurse::SpeedWord::kFast : nurse::SpeedWord::kMedium;
}

nurse::AboutQuestion shownAboutQuestion(AboutYouState::Question question) {
  using Question = AboutYouState::Question;
  switch (question) {
    case Question::kYears: return nurse::AboutQuestion::kYears;
    case Question::kHand: return nurse::AboutQuestion::kHand;
    case Question::kGloves: return nurse::AboutQuestion::kGloves;
    case Question::kHaptic: return nurse::AboutQuestion::kHaptic;
    case Question::kComfort: break;
  }
  return nurse::AboutQuestion::kComfort;
}

nurse::StopReason shownReason(StopReason reason) {
  switch (reason) {
    case StopReason::kForToday: return nurse::StopReason::kForToday;
    case StopReason::kWithdrawn: return nurse::StopReason::kWithdrawn;
    case StopReason::kNoConsent: break;
  }
  return nurse::StopReason::kNoConsent;
}

}  // namespace

nurse::WelcomeState shownWelcome(const ParticipantState& state, bool entering_code) {
  using Step = WelcomeState::Step;
  nurse::WelcomeState shown;
  shown.step = entering_code ? nurse::WelcomeStep::kEnterCode : nurse::WelcomeStep::kStart;
  if (state.welcome.step == Step::kNewCode) shown.step = nurse::WelcomeStep::kNewCode;
  if (state.welcome.step == Step::kWelcomeBack) shown.step = nurse::WelcomeStep::kWelcomeBack;
  shown.languages.clear();
  for (const QString& id : state.languages) {
    if (const auto language = nurse::languageWithId(id)) shown.languages.push_back(*language);
  }
  shown.code = state.code;
  shown.minutes = state.welcome.minutes;
  shown.kept_answers = state.welcome.kept_answers;
  shown.code_unknown = state.welcome.code_unknown;
  shown.meant = state.welcome.meant;
  shown.simulated = state.simulated;
  return shown;
}

nurse::ConsentState shownConsent(const ParticipantState& state) { return {state.consent.paragraphs, state.simulated}; }

nurse::AboutYouState shownAboutYou(const ParticipantState& state) {
  return {shownAboutQuestion(state.about.question), state.about.chosen, state.simulated};
}

nurse::DeviceCheckState shownDeviceCheck(const ParticipantState& state) {
  return {shownStep(state.device), state.simulated, state.can_go_on, state.simulated};
}

nurse::StrokeState shownStrokes(const ParticipantState& state) {
  nurse::StrokeState shown;
  shown.practice = state.screen == ParticipantScreen::kPractice;
  shown.part = state.part;
  shown.parts = state.parts;
  shown.speed = shownSpeed(state.speed.level);
  shown.recorded = state.speed.recorded;
  shown.wanted = state.speed.wanted;
  shown.note = shownNote(state.speed.note);
  shown.may_go_on = state.can_go_on;
  shown.left_handed = state.left_handed;
  shown.simulated = state.simulated;
  return shown;
}

nurse::ForceState shownForce(const ParticipantState& state) {
  using Phase = ForceState::Phase;
  nurse::ForceState shown;
  shown.practice = state.screen == ParticipantScreen::kPractice;
  shown.part = state.part;
  shown.parts = state.parts;
  shown.step = nurse::JudgingPhase::kPause;
  if (state.force.phase == Phase::kFeel) shown.step = nurse::JudgingPhase::kFeel;
  if (state.force.phase == Phase::kAnswer) shown.step = nurse::JudgingPhase::kAnswer;
  shown.asks = state.force.asks;
  shown.again = state.force.again;
  shown.warm = state.force.warm;
  shown.lit = state.force.lit;
  shown.before = state.force.before;
  shown.chosen = state.force.chosen;
  shown.left_handed = state.left_handed;
  shown.simulated = state.simulated;
  return shown;
}

nurse::QuestionState shownQuestion(const ParticipantState& state) {
  const QuestionState& asked = state.question;
  return {state.part, state.parts,  asked.position, asked.count,       asked.condition,
          asked.term, asked.region, asked.chosen,   state.left_handed, state.simulated};
}

nurse::ScaleState shownScale(const ParticipantState& state) {
  const ScaleState& asked = state.scale;
  nurse::ScaleState shown;
  const bool rating = state.screen == ParticipantScreen::kRating;
  if (rating) {
    shown.title = nurse::phrase(QStringLiteral("rate.title"));
  } else {
    shown.title =
        nurse::phrase(QStringLiteral("u.title"), {QString::number(asked.position), QString::number(asked.count)});
    shown.instructions = nurse::phrase(QStringLiteral("u.instructions"));
  }
  const QString ends = rating ? asked.sentence : QStringLiteral("u");
  shown.low = nurse::phrase(ends + QStringLiteral(".low"));
  shown.high = nurse::phrase(ends + QStringLiteral(".high"));
  shown.sentence = nurse::phrase(asked.sentence);
  shown.chosen = asked.chosen;
  shown.may_not_say = asked.may_not_say;
  shown.is_last = !rating && asked.position == asked.count;
  shown.simulated = state.simulated;
  return shown;
}

nurse::ReviewState shownReview(const ParticipantState& state) {
  nurse::ReviewState shown;
  shown.sealed = state.review.sealed;
  shown.simulated = state.simulated;
  for (const ReviewAnswer& answer : state.review.answers)
    shown.answers.push_back({answer.item, answer.condition, answer.term, answer.region, answer.word});
  return shown;
}

nurse::OwnModelState shownOwnModel(const ParticipantState& state) {
  nurse::OwnModelState shown;
  shown.region = state.own.region;
  shown.ready = state.own.ready;
  shown.unavailable = !state.own.unavailable.isEmpty();
  shown.chosen = state.own.chosen;
  shown.left_handed = state.left_handed;
  shown.simulated = state.simulated;
  return shown;
}

nurse::StoppedState shownStopped(const ParticipantState& state) {
  return {shownReason(state.stop), state.code, state.can_go_on, state.simulated};
}

QString shownCover(const ParticipantState& state) {
  switch (state.overlay) {
    case ForceOffOverlay::kForceOff:
    case ForceOffOverlay::kCalled: return QStringLiteral("off.done");
    case ForceOffOverlay::kWithdraw: return QStringLiteral("off.withdraw");
    case ForceOffOverlay::kLeaving: return QStringLiteral("nav.wait");
    case ForceOffOverlay::kNone: break;
  }
  if (state.failed) return QStringLiteral("err.save");
  return state.paused ? QStringLiteral("err.paused") : QString();
}

}  // namespace tactus::workbench
