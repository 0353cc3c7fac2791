// Placements and recordings of feeling a model, stored in a study file as events and pieces of a usability session. So
// every function that moves, exports or removes session records includes them.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/store/entries.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

// Stores placements and recordings of feeling a model as events and strokes. Private to core/store.

// Kinds of events, and level and verdicts of the strokes that are pieces of recordings.
inline constexpr std::string_view kPlacementKind = "placement";
inline constexpr std::string_view kFeelStartKind = "recording_started";
inline constexpr std::string_view kFeelEndKind = "recording_finished";
inline constexpr std::string_view kFeelMarkKind = "moment_marked";
inline constexpr std::string_view kFeelLevel = "feel";
inline constexpr std::string_view kFeelVerdict = "recorded";
/// Verdict of a piece after which samples were lost.
inline constexpr std::string_view kFeelGapVerdict = "recorded_until_gap";

study::EventRecord eventOf(const study::PlacementRecord& record);
study::EventRecord eventOf(const study::FeelMark& record);
study::EventRecord eventOf(const study::FeelStart& record);
study::EventRecord eventOf(const study::FeelEnd& record);
study::StrokeRecord strokeOf(const study::FeelPiece& record);

/// The record stored in an event. Returns an error if the detail does not match the kind.
base::Result<study::PlacementRecord> placementOf(const study::EventRecord& event);
base::Result<study::FeelMark> feelMarkOf(const study::EventRecord& event);
base::Result<study::FeelStart> feelStartOf(const study::EventRecord& event);
base::Result<study::FeelEnd> feelEndOf(const study::EventRecord& event);

/// Adds a record to its session, as `append` in entries.h. Also returns an error for a session of another kind than
/// usability, and for a number that is negative or not finite.
base::Result<void> append(StudyFile& file, const study::PlacementRecord& record);
base::Result<void> append(StudyFile& file, const study::FeelMark& record);
base::Result<void> append(StudyFile& file, const study::FeelStart& record);
base::Result<void> append(StudyFile& file, const study::FeelPiece& record);
base::Result<void> append(StudyFile& file, const study::FeelEnd& record);

/// The placements by session, in the order of insertion. Returns an error if one cannot be read.
base::Result<std::vector<study::PlacementRecord>> placements(const StudyFile& file, const Selection& selection = {});

/// The marked moments from the oldest to the newest. Returns an error if one cannot be read.
base::Result<std::vector<study::FeelMark>> feelMarks(const StudyFile& file);

/// A recording without its samples.
struct FeelSummary {
  study::FeelStart start;
  std::string code;       ///< of the person
  int pieces = 0;         ///< number of stored pieces
  double length_s = 0;    ///< duration of their samples at their rate
  bool finished = false;  ///< false: interrupted by a crash, or still in progress
  int gaps = 0;           ///< gaps between pieces where samples were lost; the times of the samples give their length

  bool operator==(const FeelSummary&) const = default;
};

/// All recordings from the oldest to the newest. Reads no samples.
base::Result<std::vector<FeelSummary>> feelRecordings(const StudyFile& file);

/// The samples of the recording `start`, its pieces joined in order. Returns an error for: an unknown recording, no
/// pieces or a missing one, pieces with different channels or rates, a piece with a wrong checksum.
base::Result<study::Recording> feelRecording(const StudyFile& file, const study::RecordId& start);

/// Checks placements and recordings. One sentence per problem: an unreadable event, a missing piece or one without a
/// recording, an end with another number of pieces.
base::Result<std::vector<std::string>> checkFeelRecords(const StudyFile& file);

/// The numbers of placements and recordings in a file.
struct FeelCounts {
  long long placements = 0;
  long long recordings = 0;
};
base::Result<FeelCounts> feelCounts(const StudyFile& file);

}  // namespace tactus::store
