// Placements and recordings of feeling a model in a study file: events and pieces of a session of the kind usability,
// which everything that moves, exports or removes records of sessions takes along.
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/store/entries.h"
#include "core/store/study_file.h"
#include "core/study/feel_records.h"

namespace tactus::store {

/// Adds a record to its session, as `append` of entries.h does. Refused besides: a session that is not of the kind
/// usability, a number that is negative or not finite.
base::Result<void> append(StudyFile& file, const study::PlacementRecord& record);
base::Result<void> append(StudyFile& file, const study::FeelStart& record);
base::Result<void> append(StudyFile& file, const study::FeelPiece& record);
base::Result<void> append(StudyFile& file, const study::FeelEnd& record);

/// The placements, session by session, in the order in which they were added. An error where one cannot be read.
base::Result<std::vector<study::PlacementRecord>> placements(const StudyFile& file, const Selection& selection = {});

/// A recording without its samples.
struct FeelSummary {
  study::FeelStart start;
  std::string code;       ///< of the person
  int pieces = 0;         ///< that are there
  double length_s = 0;    ///< of their samples at their rate
  bool finished = false;  ///< false: it was ended by a crash, or goes on
  int gaps = 0;           ///< places between pieces where samples were lost; the times of the samples tell how long

  bool operator==(const FeelSummary&) const = default;
};

/// All recordings from the oldest to the newest. No samples are read.
base::Result<std::vector<FeelSummary>> feelRecordings(const StudyFile& file);

/// The samples of the recording `start`, its pieces joined in their order. Refused: no such recording, none or a gap
/// in its pieces, pieces with different channels or rates, a piece that does not fit its checksum.
base::Result<study::Recording> feelRecording(const StudyFile& file, const study::RecordId& start);

/// What is not as it should be with placements and recordings, one sentence each: an event that cannot be read, a piece
/// that is missing or belongs to no recording, an end that counts other pieces.
base::Result<std::vector<std::string>> checkFeelRecords(const StudyFile& file);

/// How many there are.
struct FeelCounts {
  long long placements = 0;
  long long recordings = 0;
};
base::Result<FeelCounts> feelCounts(const StudyFile& file);

}  // namespace tactus::store
