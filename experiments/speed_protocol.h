// The speed experiment (paper, Section 3.1.4) as a state machine: the next stroke, and the result of the last one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/study/session_records.h"
#include "experiments/stroke.h"

namespace tactus::experiments {

struct SpeedSettings {
  enum class Order {
    kAsGiven,   ///< as in the paper: slow, medium, fast
    kShuffled,  ///< the levels in an order derived from the seed
    /// Row `latin_row` of Williams' Latin square (Williams 1949): over its rows each level stands equally often at each
    /// place and directly after each other level.
    kLatinSquare,
  };
  std::vector<std::string> levels = {"slow", "medium", "fast"};  ///< term ids
  Order order = Order::kAsGiven;
  int latin_row =
      0;             ///< of kLatinSquare; sessions take the rows in turn. 0 or more; above the last row: from the first
  int strokes = 4;   ///< per level, consecutive (paper: "consecutively four times"); 1 to 50
  int practice = 1;  ///< strokes before them at each level, not used for the model; 0 to 20
  StrokeSettings stroke;  ///< criteria for accepted strokes
  bool counts = true;     ///< false: every stroke is practice, because of the device; as many are asked for
};

/// Returns an error with one sentence for invalid settings.
base::Result<void> validate(const SpeedSettings& settings);

/// The next task of the participant. The participant never sees a speed, requested or measured.
struct SpeedPlan {
  bool finished = false;  ///< no stroke is left; all other members are then invalid
  std::string level;      ///< term id of the requested speed
  int level_place = 1;    ///< from 1: position in the order of this session
  int level_count = 0;
  bool practice = false;
  int number = 1;  ///< stroke `number` of `count` of the level's practice or strokes
  int count = 0;
  int attempt = 1;
  std::string repeat_reason;  ///< one sentence why the stroke is repeated; empty at the first attempt
  /// The same for screens in other languages: the verdict on the last attempt; kAccepted at the first attempt.
  StrokeVerdict repeat = StrokeVerdict::kAccepted;
  int accepted = 0;  ///< progress: accepted strokes without practice, of all levels
  int wanted = 0;

  bool operator==(const SpeedPlan&) const = default;
};

/// The state depends only on settings, seed and records, so an interrupted session can continue from its records.
///
/// Each stroke is repeated until one attempt is accepted; the other attempts stay on record with their verdicts. If the
/// researcher rejects an accepted stroke (a record with the verdict `rejected` that supersedes it), it is requested
/// again.
class SpeedProtocol {
 public:
  /// `records`: those of the session so far, in the order of insertion. Returns an error if they do not fit the
  /// settings.
  static base::Result<SpeedProtocol> create(const SpeedSettings& settings, std::uint64_t seed,
                                            std::span<const study::StrokeRecord> records = {});

  SpeedPlan next() const;

  /// The record of `stroke` for the task of next(). The caller completes its entry (id, session, time). `recording`:
  /// starts at sample number `recording_first` of the stream and contains the whole stroke.
  study::StrokeRecord record(const Stroke& stroke, study::Recording recording, std::size_t recording_first) const;

  /// Adds a stored record: the next stroke, or a correction of an earlier one (`entry.supersedes`). For any other
  /// record returns an error and changes nothing.
  base::Result<void> add(const study::StrokeRecord& record);

  /// Term ids in the order of this session.
  const std::vector<std::string>& levels() const noexcept { return levels_; }

 private:
  struct Slot {
    std::size_t level = 0;
    bool practice = false;
    int number = 1;

    bool operator==(const Slot&) const = default;
  };
  struct Attempt {
    study::RecordId id;
    Slot slot;
    int attempt = 1;
    StrokeVerdict verdict = StrokeVerdict::kAccepted;
    std::string reason;
  };

  SpeedProtocol(const SpeedSettings& settings, std::uint64_t seed);
  std::optional<Slot> nextSlot() const;
  bool isAccepted(const Slot& slot) const;
  int attemptsAt(const Slot& slot) const;
  base::Result<Attempt> read(const study::StrokeRecord& record) const;

  SpeedSettings settings_;
  std::vector<std::string> levels_;
  std::vector<Attempt> attempts_;  ///< a correction replaces the corrected record
};

}  // namespace tactus::experiments
