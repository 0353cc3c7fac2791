#include "app/session/session_state.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "app/session/session_notes.h"
#include "app/session/study_procedure.h"
#include "core/base/error.h"
#include "core/base/json/json_members.h"
#include "core/store/entries.h"
#include "core/store/sessions.h"
#include "elicitation/rules/question_value.h"
#include "experiments/force_series.h"
#include "questionnaires/questionnaire.h"

namespace tactus::session {
namespace {

using base::Result;
using study::RecordId;

constexpr const char* kAfter = "after";

std::optional<RecordId> afterIn(const std::string& detail_text) {
  const auto id = base::readJson(detail_text, {}, [](base::JsonMembers& json, auto&) {
    std::string after;
    json.text(kAfter, after);
    return after;
  });
  return id ? study::parseRecordId(*id) : std::nullopt;
}

}  // namespace

std::string afterDetail(const std::optional<RecordId>& latest) {
  return latest ? detail(kAfter, toText(*latest)) : std::string();
}

Result<std::vector<study::SessionRecord>> sessionsInOrder(const store::StudyFile& file, const RecordId& person) {
  auto waiting = store::sessions(file, person);  // by time and id
  if (!waiting || waiting->size() < 2) return waiting;
  TACTUS_TRY(const auto events, store::events(file, {person, {}, false}));
  std::map<RecordId, RecordId> after;
  for (const auto& event : events) {
    if (const auto before = afterIn(event.detail); before && event.kind == kBegan) {
      after.emplace(event.entry.session, *before);
    }
  }
  std::vector<study::SessionRecord> ordered;
  while (!waiting->empty()) {
    const auto is_free = [&](const study::SessionRecord& session) {
      const auto it = after.find(session.id);
      return it == after.end() ||
             std::none_of(waiting->begin(), waiting->end(), [&](const study::SessionRecord& other) {
               return other.id == it->second && other.id != session.id;
             });
    };
    auto next = std::find_if(waiting->begin(), waiting->end(), is_free);
    if (next == waiting->end()) next = waiting->begin();  // logs that contradict each other leave the time
    ordered.push_back(std::move(*next));
    waiting->erase(next);
  }
  return ordered;
}

Result<std::optional<RecordId>> latestSession(const store::StudyFile& file, const RecordId& person) {
  TACTUS_TRY(const auto ordered, sessionsInOrder(file, person));
  return ordered.empty() ? std::nullopt : std::optional(ordered.back().id);
}

namespace {

using base::Result;

void countStrokes(const std::vector<study::StrokeRecord>& strokes, SessionProgress& out) {
  for (const study::StrokeRecord& stroke : strokes) {
    if (stroke.verdict != name(experiments::StrokeVerdict::kAccepted)) continue;
    ++(stroke.practice ? out.practice : *out.speed).done;
  }
}

void planStrokes(const SessionSettings& settings, SessionProgress& out) {
  const int levels = static_cast<int>(settings.speed.levels.size());
  out.speed = Share{0, levels * settings.speed.strokes};
  out.practice.wanted += levels * settings.speed.practice;
}

// A step that was tried to the end counts as done, as the protocol leaves it out.
void countForces(const experiments::ForceProtocol& force, SessionProgress& out) {
  const auto next = force.next();
  out.force = Share{};
  bool reached = false;
  for (const experiments::SeriesStep& step : force.steps()) {
    reached = reached || (!next.finished && step == next.step);
    Share& share = step.series == experiments::kFamiliarisation ? out.practice : *out.force;
    ++share.wanted;
    if (!reached) ++share.done;
  }
}

void countReplies(const questionnaires::Progress& progress, SessionProgress& out) {
  const std::size_t done = progress.answered + progress.skipped + progress.cant_tell;
  out.form = Share{static_cast<int>(done), static_cast<int>(done + progress.open + progress.cleared)};
}

}  // namespace

Result<SessionProgress> sessionProgress(const store::StudyFile& file, const study::SessionRecord& session) {
  TACTUS_TRY(auto settings, settingsOf(file, session));
  TACTUS_TRY(const auto events, store::events(file, {{}, session.id, true}));
  SessionRecords records(session);
  records.settings = std::move(settings);
  if (auto ok = records.readBack(file, events); !ok) return tl::unexpected(ok.error());

  SessionProgress out;
  out.part = records.part();
  out.block = records.block();
  out.paused = records.paused;
  out.has_profile = records.profile.has_value();
  out.skipped = records.skipped;
  if (records.speed) {
    planStrokes(records.settings, out);
    TACTUS_TRY(const auto strokes, store::strokes(file, {{}, session.id, false}, store::Recordings::kLeaveOut));
    countStrokes(strokes, out);
  }
  if (records.force) countForces(*records.force, out);
  if (records.form) countReplies(records.form->progress(), out);
  out.sealed = records.form && records.rated.contains(Block::kForm);
  out.last_utc_ms = session.started.utc_ms;
  for (const study::EventRecord& event : events) {
    out.last_utc_ms = std::max(out.last_utc_ms, event.entry.when.utc_ms);
    const auto own = ownModelIn(event);
    if (own && *own && (*own)->verdict) ++out.own_model_verdicts;
  }
  return out;
}

using base::Result;

std::string detail(const char* key, std::string_view value) {
  // A reason may come from anywhere: what is no UTF-8 becomes U+FFFD.
  return nlohmann::json{{key, value}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string_view name(SessionPart part) noexcept {
  switch (part) {
    case SessionPart::kProfile: return "profile";
    case SessionPart::kSpeed: return "speed";
    case SessionPart::kForce: return "force";
    case SessionPart::kForm: return "form";
    case SessionPart::kRating: return "rating";
    case SessionPart::kFinished: return "finished";
    case SessionPart::kAborted: return "aborted";
  }
  return "";
}

study::Entry SessionState::entry() {
  study::Entry entry;
  entry.id = tools.ids.next();
  entry.session = record.id;
  entry.when = tools.now();
  entry.entered_by = simulated ? study::EnteredBy::kProgram : entered_by;
  return entry;
}

bool SessionRecords::isDone(Block block) const {
  switch (block) {
    case Block::kSpeed: return speed->next().finished;
    case Block::kForce: return force->next().finished;
    case Block::kForm: return form->isAtEnd() && form->isComplete();
  }
  return true;
}

std::optional<Block> SessionRecords::block() const {
  for (const Block block : settings.blocks) {
    if (!skipped.contains(block) && !(isDone(block) && rated.contains(block))) return block;
  }
  return std::nullopt;
}

SessionPart SessionRecords::part() const {
  if (aborted) return SessionPart::kAborted;
  if (!profile) return SessionPart::kProfile;
  const auto at = block();
  if (!at) return SessionPart::kFinished;
  if (isDone(*at)) return SessionPart::kRating;
  switch (*at) {
    case Block::kSpeed: return SessionPart::kSpeed;
    case Block::kForce: return SessionPart::kForce;
    case Block::kForm: return SessionPart::kForm;
  }
  return SessionPart::kFinished;
}

Result<void> SessionState::log(const char* kind, std::string text) {
  return store::append(file, study::EventRecord{entry(), kind, std::move(text)});
}

Result<void> SessionState::tell(study::ProfileRecord made, const std::optional<Note>& beside) {
  if (aborted)
    return base::fail(base::ErrorCode::kValue, "session", "a profile after its end", "a session that has not ended");
  made.entry = entry();
  if (profile) made.entry.supersedes = profile->entry.id;
  return store(
      made, [&] { profile = made; }, beside ? std::vector{*beside} : std::vector<Note>());
}

Result<void> SessionRecords::makeProtocols(const store::StudyFile& file) {
  const store::Selection history{{}, record.id, true};
  for (const Block block : settings.blocks) {
    const std::uint64_t seed = blockSeed(record.seed, block);
    if (block == Block::kSpeed) {
      TACTUS_TRY(const auto strokes, store::strokes(file, history, store::Recordings::kLeaveOut));
      experiments::SpeedSettings speeds = settings.speed;
      speeds.counts = settings.felt || settings.virtual_strokes == VirtualStrokes::kAccepted;
      TACTUS_TRY(auto made, experiments::SpeedProtocol::create(speeds, seed, strokes));
      speed = std::move(made);
    } else if (block == Block::kForce) {
      TACTUS_TRY(const auto judgements, store::judgements(file, history));
      experiments::ForceSettings forces = settings.force;
      forces.delivered = settings.felt;
      TACTUS_TRY(auto made, experiments::ForceProtocol::create(forces, seed, judgements));
      force = std::move(made);
    } else if (auto ok = makeForm(file, seed, history); !ok) {
      return ok;
    }
  }
  return {};
}

namespace {

/// Asks next what tells most about the force; null for an order that does not follow from the answers, and for a form
/// without rules.
questionnaires::QuestionnaireRun::ChooseNext leastKnown(const SessionSettings& settings) {
  using questionnaires::ItemOrder;
  if (settings.item_order != ItemOrder::kLeastKnown && settings.item_order != ItemOrder::kLeastKnownInBlocks) return {};
  const procedure::Procedure& about = settings.about();
  const study::Form* const form = about.form(settings.form);
  if (form == nullptr) return {};
  auto belief = elicitation::AnswerBelief::make(about, *form);
  if (!belief) return {};
  std::vector<std::string> terms;
  for (const fuzzy::Term& term : about.output.terms) terms.push_back(term.id);
  return
      [belief = *std::move(belief), terms](const std::vector<std::string>& values, std::span<const std::size_t> open) {
        std::vector<std::optional<std::size_t>> words(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
          const auto term = std::find(terms.begin(), terms.end(), values[i]);
          if (term != terms.end()) words[i] = static_cast<std::size_t>(term - terms.begin());
        }
        const elicitation::ForceKnown known = belief.known(words);
        const auto best = *std::max_element(open.begin(), open.end(), [&](std::size_t one, std::size_t other) {
          return known.shares[one] < known.shares[other];
        });
        return questionnaires::QuestionnaireRun::Chosen{best, {known.shares[best], known.sd_n}};
      };
}

}  // namespace

Result<void> SessionRecords::makeForm(const store::StudyFile& file, std::uint64_t seed,
                                      const store::Selection& history) {
  TACTUS_TRY(auto worded, questionnaires::questionnaire(settings.about(), settings.form, record.language));
  form.emplace(std::move(worded), settings.item_order, seed);
  TACTUS_TRY(const auto answers, store::answers(file, history));
  for (const auto& answer : answers) {
    if (auto ok = form->add(answer); !ok) return ok;
  }
  if (auto choose = leastKnown(settings)) form->chooseBy(std::move(choose));
  return {};
}

Result<void> SessionRecords::readBack(const store::StudyFile& file, const std::vector<study::EventRecord>& events) {
  const store::Selection all{{}, record.id, true};
  TACTUS_TRY(const auto profiles, store::profiles(file, {{}, record.id, false}));
  if (!profiles.empty()) profile = profiles.back();
  TACTUS_TRY(const auto ratings, store::ratings(file, all));
  for (const Block block : settings.blocks) {
    for (const auto& rating : ratings) {
      if (rating.block == name(block)) rated.insert(block);
    }
    for (const auto& event : events) {
      if (event.detail != detail("block", name(block))) continue;
      if (event.kind == kBlockSkipped) skipped.insert(block);
      if (event.kind == kBlockClosed) rated.insert(block);
    }
  }
  for (const auto& event : events) {
    if (event.kind == kPaused) paused = true;
    if (event.kind == kUnpaused) paused = false;
    if (event.kind == kAborted) aborted = true;
  }
  return makeProtocols(file);
}

}  // namespace tactus::session
