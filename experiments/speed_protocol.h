// The speed experiment (paper, Section 3.1.4) as a state machine: what to ask for next, what came of it.
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
    kShuffled,  ///< the levels in an order that follows from the seed
  };
  std::vector<std::string> levels = {"slow", "medium", "fast"};  ///< term ids
  Order order = Order::kAsGiven;
  int strokes = 4;        ///< per level, one after another (paper: "consecutively four times"); 1 to 50
  int practice = 1;       ///< strokes before them at each level, never used for the model; 0 to 20
  StrokeSettings stroke;  ///< which strokes are accepted
};

/// Refuses settings that make no sense, with one sentence.
base::Result<void> validate(const SpeedSettings& settings);

/// What the participant is to do next. No speed is shown to the participant, neither wanted nor measured.
struct SpeedPlan {
  bool finished = false;  ///< nothing is left to do; the rest then says nothing
  std::string level;      ///< term id of the speed that is asked for
  int level_place = 1;    ///< from 1: its place in the order of this session
  int level_count = 0;
  bool practice = false;
  int number = 1;  ///< stroke `number` of `count` of the level's practice or strokes
  int count = 0;
  int attempt = 1;
  std::string repeat_reason;  ///< one sentence why the stroke is repeated; empty at the first attempt
  int accepted = 0;           ///< progress: accepted strokes without practice, of all levels
  int wanted = 0;

  bool operator==(const SpeedPlan&) const = default;
};

/// The state follows from settings, seed and records alone: a session that was interrupted is resumed from its records.
///
/// Each stroke is asked for until one attempt is accepted; the others stay on record with their verdicts. Where the
/// researcher takes an accepted stroke back (a record with the verdict `rejected` that supersedes it), it is asked for
/// again.
class SpeedProtocol {
 public:
  /// `records`: those of the session so far, in the order in which they were added; refused where they do not fit.
  static base::Result<SpeedProtocol> create(const SpeedSettings& settings, std::uint64_t seed,
                                            std::span<const study::StrokeRecord> records = {});

  SpeedPlan next() const;

  /// The record of `stroke` for what next() asks for; without its entry (id, session, time), which the caller fills in.
  /// `recording` begins with the stream's sample number `recording_first` and holds the whole stroke.
  study::StrokeRecord record(const Stroke& stroke, study::Recording recording, std::size_t recording_first) const;

  /// Takes a record that was stored: the next stroke, or a correction of an earlier one (`entry.supersedes`). Refuses,
  /// without a change, what is neither.
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
  std::vector<Attempt> attempts_;  ///< a correction stands in the place of what it corrects
};

}  // namespace tactus::experiments
