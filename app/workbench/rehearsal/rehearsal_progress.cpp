#include "app/workbench/rehearsal/rehearsal_progress.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace tactus::workbench {
namespace {

using Screen = ParticipantScreen;

// Each level that was shown counts whole, the one that is being done as far as its dots go.
int insertions(const ParticipantState& state, const NurseMemory& memory) {
  int count = 0;
  for (const auto& [level, wanted] : memory.strokes) count += wanted;
  return state.screen == Screen::kSpeed ? count - state.speed.wanted + state.speed.recorded : count;
}

int answers(const SessionSnapshot* at) {
  if (at == nullptr) return 0;
  const auto given =
      std::count_if(at->replies.begin(), at->replies.end(), [](const ItemReply& reply) { return !reply.isOpen(); });
  return static_cast<int>(given);
}

}  // namespace

QString screenId(ParticipantScreen screen) {
  switch (screen) {
    case Screen::kWelcome:
      return QStringLiteral("welcome");
    case Screen::kConsent:
      return QStringLiteral("consent");
    case Screen::kAboutYou:
      return QStringLiteral("about_you");
    case Screen::kDeviceCheck:
      return QStringLiteral("device_check");
    case Screen::kPractice:
      return QStringLiteral("practice");
    case Screen::kSpeed:
      return QStringLiteral("speed");
    case Screen::kForce:
      return QStringLiteral("force");
    case Screen::kRest:
      return QStringLiteral("rest");
    case Screen::kRating:
      return QStringLiteral("rating");
    case Screen::kGlossary:
      return QStringLiteral("glossary");
    case Screen::kQuestion:
      return QStringLiteral("question");
    case Screen::kReview:
      return QStringLiteral("review");
    case Screen::kScale:
      return QStringLiteral("scale");
    case Screen::kOwnModel:
      return QStringLiteral("own_model");
    case Screen::kThanks:
      return QStringLiteral("thanks");
    case Screen::kStopped:
      break;
  }
  return QStringLiteral("stopped");
}

QByteArray progressLine(const ParticipantState& state, const SessionSnapshot* at, const NurseMemory& memory) {
  const QJsonObject line = {
      {QStringLiteral("screen"), screenId(state.screen)},
      {QStringLiteral("insertions"), insertions(state, memory)},
      {QStringLiteral("judgements"), static_cast<int>(memory.judgements.size())},
      {QStringLiteral("answers"), answers(at)},
      {QStringLiteral("ratings"), memory.ratings},
      {QStringLiteral("position"), state.screen == Screen::kQuestion ? state.question.position : 0},
      {QStringLiteral("failed"), state.failed}};
  return QJsonDocument(line).toJson(QJsonDocument::Compact);
}

}  // namespace tactus::workbench
