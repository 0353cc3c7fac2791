#include "app/session/session_state.h"

#include <nlohmann/json.hpp>

#include "questionnaires/questionnaire.h"

namespace tactus::session {

using base::Result;

std::string detail(const char* key, std::string_view value) {
  // A reason may come from anywhere: what is no UTF-8 becomes U+FFFD.
  return nlohmann::json{{key, value}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string_view name(SessionPart part) noexcept {
  switch (part) {
    case SessionPart::kProfile:
      return "profile";
    case SessionPart::kSpeed:
      return "speed";
    case SessionPart::kForce:
      return "force";
    case SessionPart::kForm:
      return "form";
    case SessionPart::kRating:
      return "rating";
    case SessionPart::kFinished:
      return "finished";
    case SessionPart::kAborted:
      return "aborted";
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
    case Block::kSpeed:
      return speed->next().finished;
    case Block::kForce:
      return force->next().finished;
    case Block::kForm:
      return form->isAtEnd() && form->isComplete();
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
    case Block::kSpeed:
      return SessionPart::kSpeed;
    case Block::kForce:
      return SessionPart::kForce;
    case Block::kForm:
      return SessionPart::kForm;
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
      const auto strokes = store::strokes(file, history, store::Recordings::kLeaveOut);
      if (!strokes) return tl::unexpected(strokes.error());
      experiments::SpeedSettings speeds = settings.speed;
      speeds.counts = settings.felt || settings.virtual_strokes == VirtualStrokes::kAccepted;
      auto made = experiments::SpeedProtocol::create(speeds, seed, *strokes);
      if (!made) return tl::unexpected(made.error());
      speed = std::move(*made);
    } else if (block == Block::kForce) {
      const auto judgements = store::judgements(file, history);
      if (!judgements) return tl::unexpected(judgements.error());
      experiments::ForceSettings forces = settings.force;
      forces.delivered = settings.felt;
      auto made = experiments::ForceProtocol::create(forces, seed, *judgements);
      if (!made) return tl::unexpected(made.error());
      force = std::move(*made);
    } else if (auto ok = makeForm(file, seed, history); !ok) {
      return ok;
    }
  }
  return {};
}

Result<void> SessionRecords::makeForm(const store::StudyFile& file, std::uint64_t seed,
                                      const store::Selection& history) {
  auto worded = questionnaires::questionnaire(settings.form, record.language);
  if (!worded) return tl::unexpected(worded.error());
  form.emplace(std::move(*worded), settings.item_order, seed);
  const auto answers = store::answers(file, history);
  if (!answers) return tl::unexpected(answers.error());
  for (const auto& answer : *answers) {
    if (auto ok = form->add(answer); !ok) return ok;
  }
  return {};
}

Result<void> SessionRecords::readBack(const store::StudyFile& file, const std::vector<study::EventRecord>& events) {
  const store::Selection all{{}, record.id, true};
  const auto profiles = store::profiles(file, {{}, record.id, false});
  if (!profiles) return tl::unexpected(profiles.error());
  if (!profiles->empty()) profile = profiles->back();
  const auto ratings = store::ratings(file, all);
  if (!ratings) return tl::unexpected(ratings.error());
  for (const Block block : settings.blocks) {
    for (const auto& rating : *ratings) {
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
