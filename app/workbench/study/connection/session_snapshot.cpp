#include "app/workbench/study/connection/session_snapshot.h"

namespace tactus::workbench {
namespace {

std::optional<questionnaires::Reply> replyOf(const study::AnswerRecord* answer) {
  if (answer == nullptr) return std::nullopt;
  return questionnaires::Reply{answer->status, answer->value};
}

void addForm(const questionnaires::QuestionnaireRun& run, const SessionSnapshot* before, SessionSnapshot& out) {
  out.form = before != nullptr ? before->form : std::make_shared<const questionnaires::Questionnaire>(run.form());
  if (const auto page = run.page()) {
    out.page = ItemPage{page->question->number, page->position, page->count, replyOf(page->last_answer)};
  }
  for (const questionnaires::Question& question : out.form->questions) {
    const auto history = run.history(question.number);
    out.replies.push_back({question.number, replyOf(history.empty() ? nullptr : &history.back())});
  }
  out.progress = run.progress();
}

}  // namespace

SessionSnapshot snapshotOf(const session::Session& session, SessionStep step, const SessionSnapshot* before) {
  if (before != nullptr && before->record->id != session.record().id) before = nullptr;
  SessionSnapshot out;
  out.step = step;
  out.record = before != nullptr ? before->record : std::make_shared<const study::SessionRecord>(session.record());
  out.settings =
      before != nullptr ? before->settings : std::make_shared<const session::SessionSettings>(session.settings());
  out.part = session.part();
  out.block = session.block();
  out.blocks_done = session.blocksDone();
  out.paused = session.isPaused();
  if (session.profile() != nullptr) out.profile = *session.profile();
  if (session.speed() != nullptr) out.speed = session.speed()->next();
  if (session.force() != nullptr) out.force = session.force()->next();
  const bool judges = out.part == session::SessionPart::kForce ||
                      (out.part == session::SessionPart::kRating && out.block == session::Block::kForce);
  if (judges && session.force()->lastScored() != nullptr) out.judged = *session.force()->lastScored();
  if (session.form() != nullptr) addForm(*session.form(), before, out);
  return out;
}

}  // namespace tactus::workbench
