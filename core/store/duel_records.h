// Blind duels of two models in a study file: plan, answers and end, stored as events of a usability session
// (docs/study-file.md, "Blind duels").
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

// Kinds of events.
inline constexpr std::string_view kDuelStartKind = "duel_started";
inline constexpr std::string_view kDuelAnswerKind = "duel_answer";
inline constexpr std::string_view kDuelEndKind = "duel_finished";

/// The words of the enumerators, in their order.
std::string_view wordOf(study::DuelQuestion question) noexcept;
std::string_view wordOf(study::DuelRule rule) noexcept;
std::string_view wordOf(study::DuelTrialKind kind) noexcept;
std::string_view wordOf(study::DuelChoice choice) noexcept;

/// Adds a record to its session, as `append` in entries.h. Also returns an error for a session of another kind than
/// usability, and for a number that is negative or not finite.
base::Result<void> append(StudyFile& file, const study::DuelStart& record);
base::Result<void> append(StudyFile& file, const study::DuelAnswer& record);
base::Result<void> append(StudyFile& file, const study::DuelEnd& record);

struct StoredDuel {
  study::DuelStart start;
  std::string code;                        ///< of the person
  std::vector<study::DuelAnswer> answers;  ///< in the order of insertion
  std::optional<study::DuelEnd> end;       ///< nothing: in progress, or interrupted

  bool operator==(const StoredDuel&) const = default;
};
/// All duels from the oldest to the newest. Returns an error if a record cannot be read.
base::Result<std::vector<StoredDuel>> duels(const StudyFile& file);

/// One sentence per problem: an unreadable record, an answer or an end without its plan.
base::Result<std::vector<std::string>> checkDuelRecords(const StudyFile& file);

}  // namespace tactus::store
