// The state of a session, and how it is read back from the file. For session.cpp only.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "app/session/session.h"
#include "core/store/batch.h"
#include "core/store/entries.h"

namespace tactus::session {

// Kinds of events in the log of a session.
inline constexpr const char* kBegan = "began";
inline constexpr const char* kResumed = "resumed";
inline constexpr const char* kStageEntered = "stage_entered";
inline constexpr const char* kPaused = "paused";
inline constexpr const char* kUnpaused = "unpaused";
inline constexpr const char* kBlockSkipped = "block_skipped";
inline constexpr const char* kBlockClosed = "block_closed";
inline constexpr const char* kAborted = "aborted";

/// `{"key":"value"}`, the detail of an event.
std::string detail(const char* key, std::string_view value);

struct SessionState {
  SessionState(store::StudyFile& study_file, SessionTools session_tools, study::SessionRecord session)
      : file(study_file), tools(std::move(session_tools)), record(std::move(session)) {}

  store::StudyFile& file;
  SessionTools tools;
  study::SessionRecord record;
  SessionSettings settings;
  bool simulated = false;
  study::EnteredBy entered_by = study::EnteredBy::kParticipant;

  std::optional<study::ProfileRecord> profile;
  std::optional<experiments::SpeedProtocol> speed;
  std::optional<experiments::ForceProtocol> force;
  std::optional<questionnaires::QuestionnaireRun> form;
  std::set<Block> rated;
  std::set<Block> skipped;
  bool paused = false;
  bool aborted = false;
  SessionPart announced = SessionPart::kProfile;  ///< of the last event `stage_entered`

  bool isDone(Block block) const;
  /// The current block (in progress or being rated).
  std::optional<Block> block() const;
  SessionPart part() const;

  /// The entry for a new record.
  study::Entry entry();
  base::Result<void> log(const char* kind, std::string text = {});
  base::Result<void> tell(study::ProfileRecord made, const std::optional<Note>& beside);

  /// Makes the protocols for the settings and feeds them the stored records.
  base::Result<void> makeProtocols();
  /// Reads all stored records of the session.
  base::Result<void> readBack();

  /// Stores `made`, and `beside` with it, if given: both or none. Then `take` changes the state.
  template <class Record, class Take>
  base::Result<void> store(const Record& made, Take take, const std::optional<Note>& beside = {}) {
    const auto stored = !beside ? store::append(file, made) : store::inOneBatch(file, [&]() -> base::Result<void> {
      if (auto ok = store::append(file, made); !ok) return ok;
      return log(beside->kind.c_str(), beside->detail);
    });
    if (!stored) return stored;
    take();
    // The record is what counts. Where the log only repeats where it leads, a failure is left to the next write.
    if (part() != announced && log(kStageEntered, detail("stage", name(part())))) announced = part();
    return {};
  }

 private:
  base::Result<void> makeForm(std::uint64_t seed, const store::Selection& history);
};

}  // namespace tactus::session
