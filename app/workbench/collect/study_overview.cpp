#include "app/workbench/collect/study_overview.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "app/session/judged_forces.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/study/connection/study_contents.h"
#include "core/base/error.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/research_key.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/study_records.h"

namespace tactus::workbench {
namespace {

struct CollectText {
  Q_DECLARE_TR_FUNCTIONS(CollectText)
};

}  // namespace

QString stepName(CollectStep step) {
  switch (step) {
    case CollectStep::kConsent: return CollectText::tr("Consent");
    case CollectStep::kDeviceCheck: return CollectText::tr("Device check");
    case CollectStep::kPractice: return CollectText::tr("Practice");
    case CollectStep::kSpeed: return CollectText::tr("Speed");
    case CollectStep::kForces: return CollectText::tr("Forces");
    case CollectStep::kQuestions: return CollectText::tr("Questions");
    case CollectStep::kReview: return CollectText::tr("Review");
    case CollectStep::kOwnModel: return CollectText::tr("Own model");
    case CollectStep::kUsability: return CollectText::tr("Usability");
  }
  return {};
}

QString stateText(const StepState& state) {
  switch (state.word) {
    case StepWord::kNotPart: return {};
    case StepWord::kOpen: return CollectText::tr("open");
    case StepWord::kPartly: return CollectText::tr("%1 of %2").arg(state.share.done).arg(state.share.wanted);
    case StepWord::kDone: return CollectText::tr("done");
    case StepWord::kSkipped: return CollectText::tr("skipped");
    case StepWord::kGiven: return CollectText::tr("imported");
    case StepWord::kUnknown: return CollectText::tr("not in this file");
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

namespace {

using base::Result;
using session::Block;
using session::SessionProgress;
using session::Share;
using study::SessionKind;
using Steps = std::array<StepState, kCollectSteps>;

StepState& at(Steps& steps, CollectStep step) { return steps[static_cast<std::size_t>(step)]; }

StepState ofShare(const std::optional<Share>& share) {
  if (!share || share->wanted == 0) return {StepWord::kNotPart, {}};
  if (share->isComplete()) return {StepWord::kDone, *share};
  return {share->done > 0 ? StepWord::kPartly : StepWord::kOpen, *share};
}

StepState ofBlock(const std::optional<Share>& share, const SessionProgress& progress, Block block) {
  const StepState state = ofShare(share);
  const bool skipped = state.word != StepWord::kNotPart && progress.skipped.contains(block);
  return skipped ? StepState{StepWord::kSkipped, state.share} : state;
}

// Tables that were imported, and rules that were given directly, take the place of a session.
void addGiven(const store::SessionSummary& summary, long long rules, Steps& steps) {
  const auto give = [&steps](CollectStep step, long long records) {
    const StepWord word = at(steps, step).word;
    if (records > 0 && (word == StepWord::kOpen || word == StepWord::kNotPart)) {
      at(steps, step) = {StepWord::kGiven, {}};
    }
  };
  give(CollectStep::kSpeed, summary.strokes);
  give(CollectStep::kForces, summary.judgements);
  give(CollectStep::kQuestions, summary.answers + rules);
}

/// The sessions of one person, by start time.
using Visits = std::vector<store::SessionSummary>;

class RowReader {
 public:
  RowReader(const store::StudyFile& file, const study::Person& person, const Visits& visits)
      : file_(file), visits_(visits) {
    row_.person = person.id;
    row_.code = text(person.code);
    row_.simulated = person.simulated;
  }

  Result<ParticipantRow> read() {
    if (auto ok = readElicitation(); !ok) return tl::unexpected(ok.error());
    if (auto ok = readOthers(); !ok) return tl::unexpected(ok.error());
    row_.next = nextOf(row_.steps, block_);
    return std::move(row_);
  }

 private:
  // The latest session that was not ended for good; else the latest.
  Result<void> readElicitation() {
    std::optional<SessionProgress> latest;
    for (const store::SessionSummary& visit : visits_) {
      row_.last_seen_ms = std::max(row_.last_seen_ms, visit.session.started.utc_ms);
      if (!visit.session.language.empty()) row_.language = text(visit.session.language);
      if (visit.session.kind != SessionKind::kElicitation) continue;
      row_.virtual_device = row_.virtual_device || (!row_.simulated && visit.strokes + visit.judgements > 0 &&
                                                    !session::givesForce(visit.session.device));
      if (!row_.simulated && !row_.setup_unchecked) {
        const auto unchecked = session::isWithoutSetup(file_, visit.session);
        row_.setup_unchecked = unchecked && *unchecked;
      }
      const auto progress = session::sessionProgress(file_, visit.session);
      if (!progress) {
        row_.trouble = text(progress.error().message());
        continue;
      }
      row_.last_seen_ms = std::max(row_.last_seen_ms, progress->last_utc_ms);
      const bool ended = progress->part == session::SessionPart::kAborted;
      if (!ended || !latest) latest = *progress;
      row_.stopped = ended;
    }
    if (latest) {
      row_.steps = stepsOf(*latest);
      block_ = latest->block;
    }
    at(row_.steps, CollectStep::kUsability).word = StepWord::kNotPart;
    return {};
  }

  Result<void> readOthers() {
    for (const store::SessionSummary& visit : visits_) {
      if (visit.session.kind == SessionKind::kUsability && visit.answers > 0) {
        at(row_.steps, CollectStep::kUsability) = {StepWord::kDone, {}};
      }
      TACTUS_TRY(const auto rules, store::rules(file_, {{}, visit.session.id, false}));
      const bool imported = visit.session.kind == SessionKind::kImport;
      if (imported) leaveOutScreens();
      if (imported || !rules.empty()) addGiven(visit, static_cast<long long>(rules.size()), row_.steps);
    }
    return {};
  }

  // Who has not sat down here was asked elsewhere.
  void leaveOutScreens() {
    if (at(row_.steps, CollectStep::kConsent).word == StepWord::kDone) return;
    row_.steps.fill({StepWord::kNotPart, {}});
    for (const CollectStep step : {CollectStep::kSpeed, CollectStep::kForces, CollectStep::kQuestions}) {
      at(row_.steps, step).word = StepWord::kOpen;
    }
    at(row_.steps, CollectStep::kConsent).word = StepWord::kUnknown;
  }

  const store::StudyFile& file_;
  const Visits& visits_;
  ParticipantRow row_;
  std::optional<Block> block_;  ///< of the session that is told
};

}  // namespace

Steps stepsOf(const SessionProgress& progress) {
  Steps steps;
  at(steps, CollectStep::kConsent) = {StepWord::kDone, {}};  // without it there is no session
  at(steps, CollectStep::kPractice) = ofShare(progress.practice);
  at(steps, CollectStep::kSpeed) = ofBlock(progress.speed, progress, Block::kSpeed);
  at(steps, CollectStep::kForces) = ofBlock(progress.force, progress, Block::kForce);
  at(steps, CollectStep::kQuestions) = ofBlock(progress.form, progress, Block::kForm);
  // The device is checked before the first movement, and before the own model is felt.
  const bool moves = progress.speed || progress.force;
  const bool moved = progress.practice.done > 0 || (progress.speed && progress.speed->done > 0) ||
                     (progress.force && progress.force->done > 0);
  const bool felt = progress.own_model_verdicts > 0;
  at(steps, CollectStep::kDeviceCheck).word = moved || felt ? StepWord::kDone
                                              : moves       ? StepWord::kOpen
                                                            : StepWord::kNotPart;
  const bool skipped_moves = !moved && at(steps, CollectStep::kSpeed).word != StepWord::kOpen &&
                             at(steps, CollectStep::kForces).word != StepWord::kOpen;
  if (moves && skipped_moves && !felt) {
    at(steps, CollectStep::kDeviceCheck).word = at(steps, CollectStep::kPractice).word = StepWord::kSkipped;
  }
  // The practice of a part is over where the part is.
  if (at(steps, CollectStep::kPractice).word == StepWord::kPartly && progress.part == session::SessionPart::kFinished) {
    at(steps, CollectStep::kPractice).word = StepWord::kDone;
  }
  const StepWord questions = at(steps, CollectStep::kQuestions).word;
  const bool left_out = questions == StepWord::kNotPart || questions == StepWord::kSkipped;
  at(steps, CollectStep::kReview).word = left_out ? questions : progress.sealed ? StepWord::kDone : StepWord::kOpen;
  at(steps, CollectStep::kOwnModel).word = felt ? StepWord::kDone : StepWord::kOpen;
  return steps;
}

std::optional<CollectStep> nextOf(const Steps& steps, std::optional<Block> block) {
  const auto first = [&steps](std::initializer_list<CollectStep> of) {
    const auto open = std::find_if(of.begin(), of.end(), [&steps](CollectStep step) {
      const StepWord word = steps[static_cast<std::size_t>(step)].word;
      return word == StepWord::kOpen || word == StepWord::kPartly;
    });
    return open == of.end() ? std::nullopt : std::optional(*open);
  };
  using enum CollectStep;
  std::optional<CollectStep> here;
  if (block == Block::kForm) here = first({kQuestions, kReview});
  if (block == Block::kSpeed || block == Block::kForce) {
    const CollectStep part = block == Block::kSpeed ? kSpeed : kForces;
    const bool begun = steps[static_cast<std::size_t>(part)].word == StepWord::kPartly;
    here = begun ? part : first({kDeviceCheck, kPractice, part});
  }
  if (here) return here;
  return first({kConsent, kDeviceCheck, kPractice, kSpeed, kForces, kQuestions, kReview, kOwnModel, kUsability});
}

Result<StudyOverview> readOverview(const store::StudyFile& file) {
  TACTUS_TRY(const auto persons, store::persons(file));
  TACTUS_TRY(const auto sessions, store::sessionList(file));
  TACTUS_TRY(const auto info, store::studyInfo(file));
  const auto has_key = store::hasResearchKey(file);

  std::map<study::RecordId, Visits> visits;
  for (const store::SessionSummary& summary : sessions) visits[summary.session.person].push_back(summary);
  StudyOverview out;
  out.protocol = {info.protocol_version, info.protocol_locked};
  out.has_key = has_key && *has_key;
  TACTUS_TRY(auto setup, session::latestSetup(file));
  out.setup = std::move(setup);
  // Researchers who feel models have a code too, as has a seal, and take part in nothing.
  TACTUS_TRY(const auto people, readPeople(file));
  std::set<study::RecordId> participants;
  for (const StudyPerson& one : people) {
    if (!one.researcher) participants.insert(one.id);
  }
  for (const study::Person& person : persons) {
    if (!participants.contains(person.id)) continue;
    TACTUS_TRY(auto row, RowReader(file, person, visits[person.id]).read());
    out.rows.push_back(std::move(row));
  }
  return out;
}

}  // namespace tactus::workbench
