// The strokes that a study has recorded, cut out of their recordings, with the state of the tube at each press. A
// stroke lasts from a press to the release. A stroke may also be made by calculation, without a hand.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/editing/edit.h"
#include "core/base/error.h"
#include "core/contracts/telling_stroke.h"
#include "core/render/renderer_state.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"
#include "core/study/session_records.h"

namespace tactus::replay {

/// What a stroke can be used for.
enum class StrokeUse : std::uint8_t {
  kExact,         ///< its own model gives the recorded force again, bit for bit
  kForceOff,      ///< of the speed experiment: only the hand was recorded, without a force
  kUnknownModel,  ///< felt on a model that the study does not keep
  kSamplesLost,   ///< the program stood still; samples are missing
  kOtherForce,    ///< its own model gives another force than was recorded
};

/// Whether a stroke of this kind is compared.
constexpr bool isCompared(StrokeUse use) { return use == StrokeUse::kExact || use == StrokeUse::kForceOff; }

struct RecordedStroke {
  study::RecordId recording;                 ///< of FeelStart, or of the stroke of the speed experiment
  int recording_number = 0;                  ///< of the recording in the study, from 1; 0: of the speed experiment
  int number = 0;                            ///< from 1 in its recording, or as in the speed experiment
  std::string person;                        ///< code
  std::string level;                         ///< of the speed experiment: the speed that was asked for
  bool simulated = false;                    ///< no person's hand
  bool calculated = false;                   ///< made by calculatedRecording
  std::map<std::string, double> conditions;  ///< of tube and patient, by id of the input; empty: not recorded
  StrokeUse use = StrokeUse::kExact;
  std::optional<double> differs_at_s;  ///< of kOtherForce and kSamplesLost: first place, since the press

  /// At the tick before the press. Its depth is without the offset of a model.
  render::RendererState at_press;
  // One value per tick, from the press to the last tick before the release.
  std::vector<double> dt_s;         ///< since the tick before
  std::vector<double> position_mm;  ///< of the hand, inward positive
  std::vector<double> recorded_n;   ///< resistance that friction and model asked for; empty if the force was off

  bool operator==(const RecordedStroke&) const = default;
};

/// A recording as the study keeps it, with the text of the model that was felt.
struct StoredRecording {
  study::RecordId id;
  int number = 0;
  std::string person;
  bool simulated = false;
  bool calculated = false;  ///< made by calculatedRecording
  bool has_gaps = false;
  study::Recording samples;
  std::string model_text;  ///< empty: the study does not keep the model
  std::string model_name;  ///< of what was felt; another one than the model's for one expert alone
};

/// The movement of one stroke of the speed experiment.
struct StoredMovement {
  study::StrokeRecord stroke;
  std::string person;
  bool simulated = false;
};

struct StoredStrokes {
  std::vector<StoredRecording> recordings;  ///< the oldest first
  std::vector<StoredMovement> movements;    ///< those that were accepted, without practice
  std::vector<std::string> unreadable;      ///< one sentence for each recording that cannot be read
};

/// Reads what `recordedStrokes` needs. Thread: that of `file`.
base::Result<StoredStrokes> storedStrokes(const store::StudyFile& file);

/// The strokes, each recording run through its own model once: that gives the state of the tube at each press, and says
/// whether the recorded force comes out again bit for bit. In the order of `stored`, recordings first. Thread: any.
std::vector<RecordedStroke> recordedStrokes(const StoredStrokes& stored);

// Strokes that are made by calculation: a test of every later version of the model.

/// The device that the setting of such a recording names.
inline constexpr const char* kNoHand = "calculated stroke, no hand";

/// The recording that the servo would make of a hand that makes `stroke` in `model`, at 1 kHz: it holds the tube at
/// rest, moves, rests and lets go. The tube follows behind the spring of the model's friction. Refused: a model that
/// the renderer refuses. Thread: any.
base::Result<study::Recording> calculatedRecording(const contracts::Stroke& stroke, const editing::ReadyModel& model);

}  // namespace tactus::replay
