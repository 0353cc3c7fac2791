#include "app/session/session_progress.h"

#include <algorithm>
#include <utility>

#include "app/session/session_notes.h"
#include "app/session/session_state.h"
#include "core/store/entries.h"
#include "experiments/force_series.h"

namespace tactus::session {
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
  auto settings = parseSessionSettings(session.settings);
  if (!settings) return tl::unexpected(settings.error());
  const auto events = store::events(file, {{}, session.id, true});
  if (!events) return tl::unexpected(events.error());
  SessionRecords records(session);
  records.settings = std::move(*settings);
  if (auto ok = records.readBack(file, *events); !ok) return tl::unexpected(ok.error());

  SessionProgress out;
  out.part = records.part();
  out.block = records.block();
  out.paused = records.paused;
  out.has_profile = records.profile.has_value();
  out.skipped = records.skipped;
  if (records.speed) {
    planStrokes(records.settings, out);
    const auto strokes = store::strokes(file, {{}, session.id, false}, store::Recordings::kLeaveOut);
    if (!strokes) return tl::unexpected(strokes.error());
    countStrokes(*strokes, out);
  }
  if (records.force) countForces(*records.force, out);
  if (records.form) countReplies(records.form->progress(), out);
  out.sealed = records.form && records.rated.contains(Block::kForm);
  out.last_utc_ms = session.started.utc_ms;
  for (const study::EventRecord& event : *events) {
    out.last_utc_ms = std::max(out.last_utc_ms, event.entry.when.utc_ms);
    const auto own = ownModelIn(event);
    if (own && *own && (*own)->verdict) ++out.own_model_verdicts;
  }
  return out;
}

}  // namespace tactus::session
