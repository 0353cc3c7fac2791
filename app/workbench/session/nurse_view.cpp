#include "app/workbench/session/nurse_view.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

using Screen = ParticipantScreen;

struct NurseViewText {
  Q_DECLARE_TR_FUNCTIONS(NurseViewText)
};

QString screenText(const ParticipantState& state) {
  if (state.screen != Screen::kStopped) return QCoreApplication::translate("ScreenFacts", factsOf(state.screen).title);
  switch (state.stop) {
    case StopReason::kForToday: return NurseViewText::tr("Stopped for today");
    case StopReason::kWithdrawn: return NurseViewText::tr("Withdrawn");
    case StopReason::kNoConsent: return NurseViewText::tr("No consent");
  }
  return {};
}

QString forceText(const ForceState& state, const experiments::ForcePlan& plan) {
  const QString force = NurseViewText::tr("%1 N%2").arg(
      numberText(plan.step.force_n),
      plan.attempt > 1 ? NurseViewText::tr(", attempt %1").arg(plan.attempt) : QString());
  switch (state.phase) {
    case ForceState::Phase::kPause:
      return state.warm ? NurseViewText::tr("The device rests before %1").arg(force)
                        : NurseViewText::tr("Pause before %1").arg(force);
    case ForceState::Phase::kFeel: return NurseViewText::tr("Feels %1").arg(force);
    case ForceState::Phase::kAnswer: return NurseViewText::tr("Answers %1").arg(force);
  }
  return {};
}

QString questionText(const QuestionState& question) {
  if (!question.unknown_n)
    return NurseViewText::tr("Question %1, the form's item %2").arg(question.position).arg(question.item);
  return NurseViewText::tr("Question %1, the form's item %2; the force is known to ± %3 N")
      .arg(question.position)
      .arg(question.item)
      .arg(*question.unknown_n, 0, 'f', 2);
}

QString nowText(const ParticipantState& state, const experiments::ForcePlan* force) {
  switch (state.screen) {
    case Screen::kSpeed:
      return NurseViewText::tr("%1, insertion %2 of %3")
          .arg(state.speed.level)
          .arg(state.speed.recorded + 1)
          .arg(state.speed.wanted);
    case Screen::kPractice:
      if (!state.feels_force) return state.speed.level;
      [[fallthrough]];
    case Screen::kForce: return force != nullptr && !force->finished ? forceText(state.force, *force) : QString();
    case Screen::kQuestion: return questionText(state.question);
    case Screen::kOwnModel:
      return state.own.count > 0 ? NurseViewText::tr("Region %1 of %2").arg(state.own.number).arg(state.own.count)
                                 : QString();
    default: return {};
  }
}

QString deviceText(DeviceStep step) {
  switch (step) {
    case DeviceStep::kWait: return NurseViewText::tr("not in use");
    case DeviceStep::kHold: return NurseViewText::tr("ready, not held");
    case DeviceStep::kStill:
    case DeviceStep::kPush:
    case DeviceStep::kRelease: return NurseViewText::tr("being checked");
    case DeviceStep::kReady: return NurseViewText::tr("ready");
    case DeviceStep::kWrong: return NurseViewText::tr("stopped for safety");
    case DeviceStep::kLost: return NurseViewText::tr("not connected");
  }
  return {};
}

}  // namespace

NurseView nurseView(const ParticipantState& state, const experiments::ForcePlan* force) {
  NurseView view;
  const bool needs = factsOf(state.screen).uses_device;
  view.code = state.code;
  view.screen = screenText(state);
  view.now = nowText(state, force);
  view.device = needs ? deviceText(state.device) : NurseViewText::tr("not in use");
  view.simulated = state.simulated;
  view.force_off = state.overlay != ForceOffOverlay::kNone;
  view.called = state.overlay == ForceOffOverlay::kCalled;
  view.call_seen = state.call_seen;
  view.stuck = state.screen == Screen::kDeviceCheck && state.waits == HoldWait::kStuck;
  view.discomfort = state.screen == Screen::kAboutYou && state.about.question == AboutYouState::Question::kComfort &&
                    state.about.chosen == QLatin1String("no");
  view.reading = NurseViewText::tr("%1, text %2 %").arg(languageName(state.language)).arg(state.text_percent);
  view.stopped = state.screen == Screen::kStopped;
  view.device_trouble = needs && (state.device == DeviceStep::kWrong || state.device == DeviceStep::kLost);
  return view;
}

}  // namespace tactus::workbench
