#include "app/workbench/collect/monitor_controller.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "core/store/entries.h"
#include "experiments/force_protocol.h"
#include "experiments/force_series.h"

namespace tactus::workbench {

void ForceTrace::add(std::span<const haptics::Sample> samples) {
  for (const haptics::Sample& sample : samples) {
    // Another run of the device begins another trace.
    if (!points_.empty() && sample.time_ns < points_.back().time_ns) points_.clear();
    if (!points_.empty() && sample.time_ns - points_.back().time_ns < kStepNs) continue;
    points_.push_back({sample.time_ns, sample.source_force_n, sample.force_n, sample.position_mm});
  }
  const auto span_ns = static_cast<std::int64_t>(kSeconds * 1e9);
  while (!points_.empty() && points_.back().time_ns - points_.front().time_ns > span_ns) points_.pop_front();
}

void ForceTrace::clear() { points_.clear(); }

bool ForceTrace::isCut() const {
  const Point* const now = newest();
  return now != nullptr && now->commanded_n > 0.05 && now->delivered_n < experiments::kLeastShare * now->commanded_n;
}

namespace {

using Kind = MonitorLine::Kind;
using session::Block;
using session::SessionPart;
using session::Share;

constexpr auto kReason = "researcher";

QString replyText(const questionnaires::Reply& reply) {
  switch (reply.status) {
    case study::Answer::Status::kAnswered: return spelled(reply.value);
    case study::Answer::Status::kSkipped: return MonitorController::tr("skipped");
    case study::Answer::Status::kCantTell: return MonitorController::tr("can't tell");
    case study::Answer::Status::kCleared: return MonitorController::tr("taken back");
  }
  return {};
}

bool isSame(const std::optional<questionnaires::Reply>& one, const std::optional<questionnaires::Reply>& other) {
  if (!one || !other) return one.has_value() == other.has_value();
  return one->status == other->status && one->value == other->value;
}

QString judgementText(const study::JudgementRecord& judgement) {
  switch (judgement.kind) {
    case study::ForceJudgement::Kind::kTerm: return spelled(judgement.term);
    case study::ForceJudgement::Kind::kNotFelt: return MonitorController::tr("not felt");
    case study::ForceJudgement::Kind::kBeyondPractice: return MonitorController::tr("beyond practice");
    case study::ForceJudgement::Kind::kNoAnswer: return MonitorController::tr("felt");
  }
  return {};
}

QString partText(const SessionSnapshot& at) {
  switch (at.part) {
    case SessionPart::kProfile: return MonitorController::tr("About the participant");
    case SessionPart::kSpeed: return MonitorController::tr("Speed");
    case SessionPart::kForce: return MonitorController::tr("Forces");
    case SessionPart::kForm: return MonitorController::tr("Questions");
    case SessionPart::kRating: return MonitorController::tr("A part is done");
    case SessionPart::kFinished: return MonitorController::tr("All parts are done");
    case SessionPart::kAborted: return MonitorController::tr("The session was ended");
  }
  return {};
}

}  // namespace

MonitorController::MonitorController(SessionProxy& session, StudyConnection& study,
                                     std::function<std::int64_t()> now_ms, QObject* parent)
    : QObject(parent), session_(session), study_(study), now_ms_(std::move(now_ms)), seen_(session.snapshot()) {
  connect(&session_, &SessionProxy::changed, this, &MonitorController::onSession);
}

std::optional<int> MonitorController::minutes() const {
  const auto at = session_.snapshot();
  if (!at || !at->record) return std::nullopt;
  constexpr std::int64_t kMinuteMs = 60'000;
  // The wall clock may have been set back since.
  return static_cast<int>(std::max<std::int64_t>(0, now_ms_() - at->record->started.utc_ms) / kMinuteMs);
}

Share MonitorController::share() const {
  const auto at = session_.snapshot();
  if (!at) return {};
  if (at->part == SessionPart::kSpeed && at->speed) return {at->speed->accepted, at->speed->wanted};
  // The ascending series ends at the latest at its highest force; of the others the length is not told before.
  if (at->part == SessionPart::kForce && at->force && at->force->step.series == experiments::kAscending) {
    return {at->force->step.step - 1, at->settings->force.ladder.count()};
  }
  if (at->part == SessionPart::kForm || (at->part == SessionPart::kRating && at->block == Block::kForm)) {
    const auto& progress = at->progress;
    const std::size_t done = progress.answered + progress.skipped + progress.cant_tell;
    return {static_cast<int>(done), static_cast<int>(done + progress.cleared + progress.open)};
  }
  return {};
}

bool MonitorController::isPaused() const {
  const auto at = session_.snapshot();
  return paused_here_ && at && at->paused;
}

bool MonitorController::canPause() const {
  const auto at = session_.snapshot();
  const bool over = at && (at->part == SessionPart::kAborted || at->part == SessionPart::kFinished);
  return at && !over && !at->paused;
}

void MonitorController::show(const NurseView& nurse) {
  if (nurse == nurse_) return;
  const bool calls = nurse.called && !nurse_.called;
  nurse_ = nurse;
  if (calls) addLine(Kind::kCall, tr("The participant has called you"));
  emit changed();
}

void MonitorController::add(std::span<const haptics::Sample> samples) {
  trace_.add(samples);
  emit traced();
}

void MonitorController::say(const QString& sentence) { addLine(Kind::kCall, sentence); }

void MonitorController::pause() {
  if (!canPause()) return;
  paused_here_ = true;
  session_.pause(kReason);
}

void MonitorController::goOn() {
  if (isPaused()) session_.unpause();
}

void MonitorController::note(const QString& words) {
  const QString clean = words.simplified();
  if (clean.isEmpty() || !session_.snapshot()) return;
  session_.note(session::researcherNote(clean.toStdString()));
  addLine(Kind::kNote, clean);
}

void MonitorController::onSession() {
  const auto now = session_.snapshot();
  const auto before = std::exchange(seen_, now);
  if (now && !now->paused) paused_here_ = paused_here_ && session_.isSaving();
  if (before != now && now) {
    const bool same = before && before->record->id == now->record->id;
    if (!same) {
      addLine(Kind::kStage, tr("The session has begun: %1").arg(partText(*now)));
    } else {
      compare(*before, *now);
    }
  }
  emit changed();
}

void MonitorController::compare(const SessionSnapshot& before, const SessionSnapshot& now) {
  if (before.paused != now.paused) addLine(Kind::kStage, now.paused ? tr("Paused") : tr("Goes on"));
  compareStrokes(before, now);
  compareReplies(before, now);
  const bool judged = before.part == SessionPart::kForce && before.force != now.force;
  if (judged) readJudgement(now.record->id);
  if (before.part != now.part) addLine(Kind::kStage, partText(now));
}

void MonitorController::compareStrokes(const SessionSnapshot& before, const SessionSnapshot& now) {
  if (before.part != SessionPart::kSpeed || !before.speed || !now.speed || *before.speed == *now.speed) return;
  const experiments::SpeedPlan& was = *before.speed;
  const QString which = tr("%1, insertion %2%3")
                            .arg(spelled(was.level))
                            .arg(was.number)
                            .arg(was.practice ? tr(" (practice)") : QString());
  const bool again = now.speed->level == was.level && now.speed->number == was.number &&
                     now.speed->practice == was.practice && now.speed->attempt > was.attempt;
  if (again) {
    addLine(Kind::kUnscored, tr("%1: not recorded, %2").arg(which, text(now.speed->repeat_reason)));
  } else {
    addLine(Kind::kAnswer, tr("%1: recorded").arg(which));
  }
}

void MonitorController::compareReplies(const SessionSnapshot& before, const SessionSnapshot& now) {
  for (std::size_t i = 0; i < now.replies.size() && i < before.replies.size(); ++i) {
    if (isSame(now.replies[i].reply, before.replies[i].reply) || !now.replies[i].reply) continue;
    addLine(Kind::kAnswer, tr("Question %1: %2").arg(now.replies[i].item).arg(replyText(*now.replies[i].reply)));
  }
}

// The record says more than the snapshot: whether the force was delivered and the judgement is scored. It is read after
// the participant's next screen has opened.
void MonitorController::readJudgement(const study::RecordId& session) {
  study_.read(*this, [this, session](const store::StudyFile& file) -> StudyConnection::Deliver {
    const auto judgements = store::judgements(file, {{}, session, true});
    if (!judgements || judgements->empty()) return {};
    return [this, last = judgements->back()] {
      const QString force = tr("%1 N: %2").arg(numberText(last.commanded_n), judgementText(last));
      const bool practice = last.kind == study::ForceJudgement::Kind::kNoAnswer;
      if (last.scored || practice) {
        addLine(Kind::kAnswer, force);
      } else if (last.delivered_share && *last.delivered_share < experiments::kLeastShare) {
        addLine(Kind::kUnscored, tr("%1, not scored: only %2 % of the force was delivered")
                                     .arg(force)
                                     .arg(static_cast<int>(*last.delivered_share * 100)));
      } else {
        addLine(Kind::kUnscored, tr("%1, not scored").arg(force));
      }
    };
  });
}

void MonitorController::addLine(Kind kind, const QString& text) {
  lines_.push_back({kind, now_ms_(), text});
  emit lineAdded();
}

}  // namespace tactus::workbench
