// The participants of a study and how far each has come: the rows of the study's home; and the record of each.
#pragma once

#include <QString>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/session/session_state.h"
#include "app/session/setup_certificate.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

/// What a participant goes through, in this order. The usability form is a session of its own.
enum class CollectStep {
  kConsent,
  kDeviceCheck,
  kPractice,
  kSpeed,
  kForces,
  kQuestions,
  kReview,
  kOwnModel,
  kUsability,
};
inline constexpr std::size_t kCollectSteps = 9;

enum class StepWord {
  kNotPart,  ///< the protocol has no such block
  kOpen,     ///< nothing of it yet
  kPartly,   ///< some of it
  kDone,
  kSkipped,  ///< left out by the researcher
  kGiven,    ///< the data came otherwise: imported tables, rules given directly
  kUnknown,  ///< this file does not say
};

struct StepState {
  StepWord word = StepWord::kOpen;
  session::Share share;  ///< of kPartly

  bool operator==(const StepState&) const = default;
};

struct ParticipantRow {
  study::RecordId person;
  QString code;
  bool simulated = false;
  bool virtual_device = false;    ///< a real person on a device that gives no force
  bool setup_unchecked = false;   ///< a real person whose set-up was not checked before the session
  QString language;               ///< of the latest session; empty: none yet
  std::int64_t last_seen_ms = 0;  ///< UTC; 0: never
  std::array<StepState, kCollectSteps> steps;
  std::optional<CollectStep> next;  ///< nothing: all is done
  bool stopped = false;             ///< the latest session was ended for good
  QString trouble;                  ///< why the steps cannot be told; empty: they can

  const StepState& at(CollectStep step) const { return steps[static_cast<std::size_t>(step)]; }
};

/// The study's protocol, in short.
struct ProtocolSummary {
  int version = 0;  ///< 0: none was set
  bool locked = false;
};

struct StudyOverview {
  std::vector<ParticipantRow> rows;  ///< by code
  ProtocolSummary protocol;
  bool has_key = false;                            ///< a research key is set
  std::optional<session::SetupCertificate> setup;  ///< the latest check of the set-up; nothing: there was none
};

/// Reads no recordings. A session that cannot be read keeps its participant in the list, with `trouble`.
/// Thread: that of `file`.
base::Result<StudyOverview> readOverview(const store::StudyFile& file);

/// The states that follow from `progress` of an elicitation session.
std::array<StepState, kCollectSteps> stepsOf(const session::SessionProgress& progress);
/// The first step that is open or partly done. `block`: being done or rated; its steps come before those of the blocks
/// that the protocol puts later.
std::optional<CollectStep> nextOf(const std::array<StepState, kCollectSteps>& steps,
                                  std::optional<session::Block> block = {});

// The record of one participant: each line that the file holds about them.

struct RecordLine {
  study::RecordId id;
  int session = 1;            ///< from 1, by its start
  std::int64_t utc_ms = 0;    ///< when it was stored
  std::int64_t sequence = 0;  ///< its place in the file
  QString part;               ///< Person, Speed, Forces, Questions, Rating, Log
  QString asked;              ///< what it is about
  QString said;               ///< what was answered or done
  bool is_log = false;        ///< a line that the screens wrote, no answer
  QString remark;             ///< not counted, corrected, the reason of a correction; may be empty
};

/// All lines of `person`, with those that were corrected. Reads no recordings. Thread: that of `file`.
base::Result<std::vector<RecordLine>> readParticipantRecord(const store::StudyFile& file,
                                                            const study::RecordId& person);

// The words of stage Collect: steps of a participant and how far they are.

/// `Device check`, as short as a column.
QString stepName(CollectStep step);
/// `done`, `12 of 45`, `open`, `skipped`, `imported`; empty for what is no part of the session.
QString stateText(const StepState& state);
/// The same for a reader of the screen, which has no empty cells.
QString spokenState(const StepState& state);
/// What to do next with the participant: a step, `all done`, or that the session was ended.
QString nextText(const ParticipantRow& row);
/// `today 14:05`, `2026-11-20`, `never`; `now_ms`: the present, UTC.
QString lastSeenText(std::int64_t last_seen_ms, std::int64_t now_ms);

}  // namespace tactus::workbench
