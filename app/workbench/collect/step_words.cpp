#include "app/workbench/collect/step_words.h"

#include <QCoreApplication>
#include <QDateTime>

namespace tactus::workbench {
namespace {

struct CollectText {
  Q_DECLARE_TR_FUNCTIONS(CollectText)
};

}  // namespace

QString stepName(CollectStep step) {
  switch (step) {
    case CollectStep::kConsent:
      return CollectText::tr("Consent");
    case CollectStep::kDeviceCheck:
      return CollectText::tr("Device check");
    case CollectStep::kPractice:
      return CollectText::tr("Practice");
    case CollectStep::kSpeed:
      return CollectText::tr("Speed");
    case CollectStep::kForces:
      return CollectText::tr("Forces");
    case CollectStep::kQuestions:
      return CollectText::tr("Questions");
    case CollectStep::kReview:
      return CollectText::tr("Review");
    case CollectStep::kOwnModel:
      return CollectText::tr("Own model");
    case CollectStep::kUsability:
      return CollectText::tr("Usability");
  }
  return {};
}

QString stateText(const StepState& state) {
  switch (state.word) {
    case StepWord::kNotPart:
      return {};
    case StepWord::kOpen:
      return CollectText::tr("open");
    case StepWord::kPartly:
      return CollectText::tr("%1 of %2").arg(state.share.done).arg(state.share.wanted);
    case StepWord::kDone:
      return CollectText::tr("done");
    case StepWord::kSkipped:
      return CollectText::tr("skipped");
    case StepWord::kGiven:
      return CollectText::tr("imported");
    case StepWord::kUnknown:
      return CollectText::tr("not in this file");
  }
  return {};
}

QString spokenState(const StepState& state) {
  return state.word == StepWord::kNotPart ? CollectText::tr("not part of it") : stateText(state);
}

QString nextText(const ParticipantRow& row) {
  if (!row.trouble.isEmpty()) return CollectText::tr("cannot be read");
  if (!row.next) return CollectText::tr("all done");
  if (row.stopped) return CollectText::tr("ended early");
  return stepName(*row.next);
}

QString lastSeenText(std::int64_t last_seen_ms, std::int64_t now_ms) {
  if (last_seen_ms <= 0) return CollectText::tr("never");
  const QDateTime seen = QDateTime::fromMSecsSinceEpoch(last_seen_ms);
  const bool today = seen.date() == QDateTime::fromMSecsSinceEpoch(now_ms).date();
  if (today) return CollectText::tr("today %1").arg(seen.toString(QStringLiteral("HH:mm")));
  return seen.toString(QStringLiteral("yyyy-MM-dd"));
}

}  // namespace tactus::workbench
