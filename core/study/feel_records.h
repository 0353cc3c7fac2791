// The records of feeling a model: placements of the tube as numbers, and recordings of hand and force. They are stored
// in a session of the kind usability, as events and pieces of recordings (docs/study-file.md, "Feeling a model").
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "core/study/record_id.h"
#include "core/study/session_records.h"

namespace tactus::study {

/// The model and the device of a placement or recording.
struct FeltSetting {
  std::string device;                        ///< name and serial number
  bool simulated = false;                    ///< no hardware: the program computed hand, device and force
  std::string model;                         ///< its name
  std::optional<RecordId> model_version;     ///< the version in the same study; empty: a model from outside the study
  std::map<std::string, double> conditions;  ///< of tube and patient, by id of the model's input, in its unit

  bool operator==(const FeltSetting&) const = default;
};

/// One placement of the tube, from the first grip to the last release.
struct PlacementRecord {
  Entry entry;
  FeltSetting setting;
  double duration_s = 0;
  int strokes = 0;
  double peak_force_n = 0;  ///< largest resistance on the hand
  double mean_force_n = 0;  ///< mean resistance while the hand held the tube
  double depth_mm = 0;      ///< deepest position of the tip

  bool operator==(const PlacementRecord&) const = default;
};

/// The start of a recording. The id of its entry identifies the recording.
struct FeelStart {
  Entry entry;
  FeltSetting setting;
  int number = 1;  ///< from 1 within the session

  bool operator==(const FeelStart&) const = default;
};

/// A few seconds of a recording, stored while the recording continues.
struct FeelPiece {
  Entry entry;
  int recording = 1;         ///< FeelStart::number
  int number = 1;            ///< from 1 within the recording, without gaps
  Recording samples;         ///< channels as in docs/study-file.md
  bool gap_follows = false;  ///< samples between this piece and the next were lost

  bool operator==(const FeelPiece&) const = default;
};

/// The end of a recording. A recording without an end was interrupted by a crash and holds the pieces stored before.
struct FeelEnd {
  Entry entry;
  int recording = 1;  ///< FeelStart::number
  int pieces = 0;     ///< number of pieces

  bool operator==(const FeelEnd&) const = default;
};

}  // namespace tactus::study
