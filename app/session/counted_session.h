// Which session counts where a participant did a part of the elicitation more than once.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::session {

/// A part of the elicitation that is compared between sessions as a whole.
struct ElicitedBlock {
  enum class Kind { kSpeedLevel, kForceSeries, kForm, kRules };
  Kind kind = Kind::kRules;
  std::string id;  ///< of the level, series or form; empty for rules

  auto operator<=>(const ElicitedBlock&) const = default;
};

/// `the speed 'slow'`, `the rules`.
std::string text(const ElicitedBlock& block);

/// What one session has of a block.
struct BlockInSession {
  study::SessionRecord session;
  std::size_t scored = 0;  ///< records that elicitation uses: accepted strokes, scored judgements, answers, rules
  bool complete = false;
};

/// Whether `scored` records are all that the session planned of the block: the strokes of the level; the steps of the
/// series up to its end; a reply to each item of the form. Imported tables and rules are complete as they are. A
/// session whose plan cannot be read is not known to be complete.
base::Result<bool> isComplete(const store::StudyFile& file, const study::SessionRecord& session,
                              const ElicitedBlock& block, std::size_t scored);

/// The place in `sessions`, which stand in their order (session_order.h), of the one that counts: the latest that is
/// complete; where none is, the one with most scored records, and of several such the latest. At least one session.
std::size_t countedSession(std::span<const BlockInSession> sessions);

/// The sentence that names the session that counts and the others.
std::string note(const std::string& participant, const ElicitedBlock& block, std::span<const BlockInSession> sessions);

}  // namespace tactus::session
