#include "app/workbench/participant/participant_course.h"

#include "experiments/force_series.h"

namespace tactus::workbench {
namespace {

using session::Block;
using session::SessionPart;

ParticipantScreen withDevice(const CoursePassed& passed, ParticipantScreen screen) {
  return passed.device ? screen : ParticipantScreen::kDeviceCheck;
}

ParticipantScreen formScreen(const SessionSnapshot& at, const CoursePassed& passed) {
  if (!passed.glossary) return ParticipantScreen::kGlossary;
  return at.page ? ParticipantScreen::kQuestion : ParticipantScreen::kReview;
}

}  // namespace

std::string restBefore(const SessionSnapshot& at, const CoursePassed& passed) {
  const bool in_block =
      at.part == SessionPart::kSpeed || at.part == SessionPart::kForce || at.part == SessionPart::kForm;
  if (in_block && at.blocks_done > passed.blocks) {
    const std::string between = "before_" + std::string(name(*at.block));
    if (!passed.rests.contains(between)) return between;
  }
  if (at.part == SessionPart::kForce && at.force->question.rest_first) {
    const auto& step = at.force->step;
    return step.series + ' ' + std::to_string(step.step) + ' ' + std::to_string(at.force->attempt);
  }
  const bool next_question = at.part == SessionPart::kForm && at.page && !at.page->reply;
  const bool due = next_question && passed.replies > 0 && (at.page->position - 1) % kQuestionsToRest == 0;
  return due ? "question_" + std::to_string(at.page->position) : std::string();
}

bool isUsability(const SessionSnapshot& at) { return at.record && at.record->kind == study::SessionKind::kUsability; }

bool usesDevice(ParticipantScreen screen) {
  switch (screen) {
    case ParticipantScreen::kDeviceCheck:
    case ParticipantScreen::kPractice:
    case ParticipantScreen::kSpeed:
    case ParticipantScreen::kForce:
    case ParticipantScreen::kOwnModel:
      return true;
    default:
      return false;
  }
}

ParticipantScreen screenOf(const SessionSnapshot* at, const CoursePassed& passed) {
  if (passed.stopped) return ParticipantScreen::kStopped;
  if (at == nullptr) return passed.code ? ParticipantScreen::kConsent : ParticipantScreen::kWelcome;
  if (at->part == SessionPart::kAborted) return ParticipantScreen::kStopped;
  if (isUsability(*at)) {
    return at->part == SessionPart::kFinished ? ParticipantScreen::kThanks : ParticipantScreen::kScale;
  }
  const std::string rest = restBefore(*at, passed);
  if (!rest.empty() && !passed.rests.contains(rest)) return ParticipantScreen::kRest;
  switch (at->part) {
    case SessionPart::kProfile:
      return ParticipantScreen::kAboutYou;
    case SessionPart::kSpeed:
      return withDevice(passed, at->speed->practice ? ParticipantScreen::kPractice : ParticipantScreen::kSpeed);
    case SessionPart::kForce: {
      const bool practice = at->force->step.series == experiments::kFamiliarisation;
      return withDevice(passed, practice ? ParticipantScreen::kPractice : ParticipantScreen::kForce);
    }
    case SessionPart::kForm:
      return formScreen(*at, passed);
    case SessionPart::kRating:
      return at->block == Block::kForm && !passed.sealing ? ParticipantScreen::kReview : ParticipantScreen::kRating;
    case SessionPart::kFinished:
      if (at->form && !passed.sealed) return ParticipantScreen::kReview;
      return passed.own_model ? ParticipantScreen::kThanks : withDevice(passed, ParticipantScreen::kOwnModel);
    case SessionPart::kAborted:
      break;
  }
  return ParticipantScreen::kStopped;
}

}  // namespace tactus::workbench
