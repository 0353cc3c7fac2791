// The state of a session, and how it is read back from the file. For session.cpp and session_state.cpp only.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/session/session.h"
#include "app/session/session_settings.h"
#include "core/base/error.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::session {

// The order of a participant's sessions, independent of the clocks of the stations.

/// The detail of a session's first event: the participant's latest session in the file when this one began. Exports and
/// merges keep it.
std::string afterDetail(const std::optional<study::RecordId>& latest);

/// The sessions of `person`, earliest first. A session comes after the one that its log names. Sessions without such a
/// relation, for example of two stations, are ordered by their start time, then by id. So a clock that was set back
/// does not change the order within a file, and the order of merges never does.
base::Result<std::vector<study::SessionRecord>> sessionsInOrder(const store::StudyFile& file,
                                                                const study::RecordId& person);

/// The last of them; nothing if there is none.
base::Result<std::optional<study::RecordId>> latestSession(const store::StudyFile& file, const study::RecordId& person);

// How far a session has come, read from the study file alone: nothing is added to its log.

/// Things done of things planned.
struct Share {
  int done = 0;
  int wanted = 0;

  bool isComplete() const { return done >= wanted; }
  bool operator==(const Share&) const = default;
};

/// A part is nothing where the session has no such block.
struct SessionProgress {
  SessionPart part = SessionPart::kProfile;
  std::optional<Block> block;  ///< in progress or being rated
  bool paused = false;
  bool has_profile = false;
  std::set<Block> skipped;
  Share practice;                ///< insertions and forces before the counted ones
  std::optional<Share> speed;    ///< accepted insertions
  std::optional<Share> force;    ///< forces; `wanted` falls where a series ends early
  std::optional<Share> form;     ///< questions with a reply
  bool sealed = false;           ///< the participant locked the answers to the form, or rated it
  int own_model_verdicts = 0;    ///< regions of the own model that were judged
  std::int64_t last_utc_ms = 0;  ///< time of the last line of the log
};

/// Errors: settings or records that cannot be read. Reads no recordings. Thread: that of `file`.
base::Result<SessionProgress> sessionProgress(const store::StudyFile& file, const study::SessionRecord& session);

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

/// What is stored of a session, and what follows from it.
struct SessionRecords {
  explicit SessionRecords(study::SessionRecord session) : record(std::move(session)) {}

  study::SessionRecord record;
  SessionSettings settings;
  std::optional<study::ProfileRecord> profile;
  std::optional<experiments::SpeedProtocol> speed;
  std::optional<experiments::ForceProtocol> force;
  std::optional<questionnaires::QuestionnaireRun> form;
  std::set<Block> rated;
  std::set<Block> skipped;
  bool paused = false;
  bool aborted = false;

  bool isDone(Block block) const;
  /// The current block (in progress or being rated).
  std::optional<Block> block() const;
  SessionPart part() const;

  /// Makes the protocols for the settings and feeds them the stored records.
  base::Result<void> makeProtocols(const store::StudyFile& file);
  /// Reads all stored records of the session. `events`: its log.
  base::Result<void> readBack(const store::StudyFile& file, const std::vector<study::EventRecord>& events);

 private:
  base::Result<void> makeForm(const store::StudyFile& file, std::uint64_t seed, const store::Selection& history);
};

struct SessionState : SessionRecords {
  SessionState(store::StudyFile& study_file, SessionTools session_tools, study::SessionRecord session)
      : SessionRecords(std::move(session)), file(study_file), tools(std::move(session_tools)) {}

  store::StudyFile& file;
  SessionTools tools;
  bool simulated = false;
  study::EnteredBy entered_by = study::EnteredBy::kParticipant;
  SessionPart announced = SessionPart::kProfile;  ///< of the last event `stage_entered`

  /// The entry for a new record.
  study::Entry entry();
  base::Result<void> log(const char* kind, std::string text = {});
  base::Result<void> tell(study::ProfileRecord made, const std::optional<Note>& beside);

  /// Stores `made`, and the lines `beside` with it: all or none. Then `take` changes the state.
  template <class Record, class Take>
  base::Result<void> store(const Record& made, Take take, const std::vector<Note>& beside = {}) {
    const auto stored =
        beside.empty() ? store::append(file, made) : store::inOneBatch(file, [&]() -> base::Result<void> {
          if (auto ok = store::append(file, made); !ok) return ok;
          for (const Note& note : beside) {
            if (auto ok = log(note.kind.c_str(), note.detail); !ok) return ok;
          }
          return {};
        });
    if (!stored) return stored;
    take();
    // The record is what counts. Where the log only repeats where it leads, a failure is left to the next write.
    if (part() != announced && log(kStageEntered, detail("stage", name(part())))) announced = part();
    return {};
  }
};

}  // namespace tactus::session
