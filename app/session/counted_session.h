// Decides which session counts if a participant did a block of the elicitation more than once.
// A block is a part of the elicitation that is compared between sessions as a whole:
//   S1 did the speed level `slow` in session 1 (complete) and session 2 (aborted): session 1 counts.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::session {

/// One block: a speed level, a force series, a form, or the rules.
struct ElicitedBlock {
  enum class Kind { kSpeedLevel, kForceSeries, kForm, kRules };
  Kind kind = Kind::kRules;
  std::string id;  ///< of the level, series or form; empty for rules

  auto operator<=>(const ElicitedBlock&) const = default;
};

/// `the speed 'slow'`, `the rules`.
std::string text(const ElicitedBlock& block);

/// The records of a block in one session.
struct BlockInSession {
  study::SessionRecord session;
  std::size_t scored = 0;  ///< number of records that elicitation uses: accepted strokes, scored judgements, answers,
                           ///< rules
  bool complete = false;
};

/// Whether `scored` records are all that the session planned for the block: the strokes of the level; the steps of the
/// series up to its end; a reply to each item of the form. Imported tables and rules are always complete. False for a
/// session with an unreadable plan. Errors: of reading the file.
base::Result<bool> isComplete(const store::StudyFile& file, const study::SessionRecord& session,
                              const ElicitedBlock& block, std::size_t scored);

/// The index in `sessions` (in the order of session_order.h) of the session that counts: the latest complete one; if
/// none is complete, the one with the most scored records, and of several such the latest. `sessions` must not be
/// empty.
std::size_t countedSession(std::span<const BlockInSession> sessions);

/// The sentence that names the session that counts and the others.
std::string note(const std::string& participant, const ElicitedBlock& block, std::span<const BlockInSession> sessions);

}  // namespace tactus::session
