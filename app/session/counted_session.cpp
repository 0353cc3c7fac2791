#include "app/session/counted_session.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <set>

#include "app/session/session_settings.h"
#include "core/base/check.h"
#include "core/base/clock.h"
#include "core/store/entries.h"
#include "experiments/force_protocol.h"
#include "questionnaires/questionnaire.h"

namespace tactus::session {
namespace {

using base::Result;
using BlockKind = ElicitedBlock::Kind;

/// The series in the order of the force experiment, or a place behind all of them.
std::size_t placeOf(const std::string& series) {
  constexpr std::array<const char*, 4> kOrder = {experiments::kFamiliarisation, experiments::kAscending,
                                                 experiments::kDescending, experiments::kRandom};
  return static_cast<std::size_t>(std::find(kOrder.begin(), kOrder.end(), series) - kOrder.begin());
}

Result<bool> isSeriesDone(const store::StudyFile& file, const study::SessionRecord& session,
                          const SessionSettings& settings, const std::string& series) {
  const auto judgements = store::judgements(file, {{}, session.id, true});
  if (!judgements) return tl::unexpected(judgements.error());
  const auto protocol =
      experiments::ForceProtocol::create(settings.force, blockSeed(session.seed, Block::kForce), *judgements);
  if (!protocol) return false;
  const auto plan = protocol->next();
  return plan.finished || placeOf(plan.step.series) > placeOf(series);
}

Result<bool> isFormDone(const store::StudyFile& file, const study::SessionRecord& session, const std::string& form) {
  const auto worded = questionnaires::questionnaire(form, session.language);
  if (!worded) return false;
  const auto answers = store::answers(file, {{}, session.id, false});
  if (!answers) return tl::unexpected(answers.error());
  std::set<int> items;
  for (const auto& answer : *answers) {
    if (answer.form == form && answer.status != study::Answer::Status::kCleared) items.insert(answer.item);
  }
  return items.size() >= worded->questions.size();
}

std::string sessionText(const BlockInSession& one) {
  using std::chrono::milliseconds;
  const std::chrono::system_clock::time_point started{milliseconds(one.session.started.utc_ms)};
  return "the one of " + base::formatUtc(started) + " (" +
         (one.session.kind == study::SessionKind::kImport ? "imported"
          : one.complete                                  ? "complete"
                                                          : "not complete") +
         ", records " + std::to_string(one.scored) + ", session " + toText(one.session.id).substr(0, 8) + ")";
}

}  // namespace

std::string text(const ElicitedBlock& block) {
  switch (block.kind) {
    case BlockKind::kSpeedLevel:
      return "the speed " + base::quoted(block.id);
    case BlockKind::kForceSeries:
      return "the series " + base::quoted(block.id);
    case BlockKind::kForm:
      return "the form " + base::quoted(block.id);
    case BlockKind::kRules:
      return "the rules";
  }
  return {};
}

Result<bool> isComplete(const store::StudyFile& file, const study::SessionRecord& session, const ElicitedBlock& block,
                        std::size_t scored) {
  if (session.kind == study::SessionKind::kImport || block.kind == BlockKind::kRules) return true;
  const auto settings = parseSessionSettings(session.settings);
  if (!settings || session.settings.empty()) return false;
  switch (block.kind) {
    case BlockKind::kSpeedLevel:
      return scored >= static_cast<std::size_t>(std::max(settings->speed.strokes, 0));
    case BlockKind::kForceSeries:
      return isSeriesDone(file, session, *settings, block.id);
    case BlockKind::kForm:
      return isFormDone(file, session, block.id);
    case BlockKind::kRules:
      break;
  }
  return true;
}

std::size_t countedSession(std::span<const BlockInSession> sessions) {
  TACTUS_CHECK(!sessions.empty());
  std::size_t best = 0;
  for (std::size_t i = 1; i < sessions.size(); ++i) {
    const BlockInSession& one = sessions[i];
    const bool counts = one.complete || (!sessions[best].complete && one.scored >= sessions[best].scored);
    if (counts) best = i;
  }
  return best;
}

std::string note(const std::string& participant, const ElicitedBlock& block, std::span<const BlockInSession> sessions) {
  const std::size_t counted = countedSession(sessions);
  std::string others;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    if (i != counted) others += (others.empty() ? "" : ", ") + sessionText(sessions[i]);
  }
  return participant + " did " + text(block) + " in more than one session: " + sessionText(sessions[counted]) +
         " counts, not " + others + ".";
}

}  // namespace tactus::session
