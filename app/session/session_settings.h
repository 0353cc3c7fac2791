// The settings of a session: its blocks and how each is run, and their text in the study file.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/procedure/procedure.h"
#include "experiments/force_series.h"
#include "experiments/speed_protocol.h"
#include "questionnaires/questionnaire_run.h"

namespace tactus::base {
class JsonMembers;
}

namespace tactus::session {

/// A part of a session. After each block the participant rates effort and comfort.
enum class Block { kSpeed, kForce, kForm };

/// `speed`, `force`, `form`.
std::string_view name(Block block) noexcept;

/// What becomes of strokes on a device that gives no force.
enum class VirtualStrokes {
  kPractice,  ///< recorded as practice
  kAccepted,  ///< they count as on any device
};

/// How the handle of a device with a button is held.
enum class Grip {
  kHeld,   ///< the button is kept pressed
  kLatch,  ///< a press holds, another one lets go: a squeezed switch changes the feel
};

struct SessionSettings {
  std::vector<Block> blocks = {Block::kSpeed, Block::kForce, Block::kForm};  ///< each at most once
  experiments::SpeedSettings speed;
  experiments::ForceSettings force;
  std::string form = "ngt-force-v1";
  questionnaires::ItemOrder item_order = questionnaires::ItemOrder::kFixed;
  VirtualStrokes virtual_strokes = VirtualStrokes::kPractice;  ///< `virtual` in the text
  Grip grip = Grip::kHeld;
  /// False in a session of a real person on a device that gives no force: no judgement is scored, and strokes are what
  /// `virtual_strokes` says. Set when a session begins, no value of a protocol.
  bool felt = true;
  /// What the study is about; null: the default procedure. Set by who reads the settings, no value of a protocol.
  std::shared_ptr<const procedure::Procedure> procedure = {};

  const procedure::Procedure& about() const { return procedure::orDefault(procedure); }
};

/// The session of a clinical teacher who tried the simulator: only the usability form (paper, Section 5.4).
SessionSettings usabilitySession();

/// About how long a session takes, in min: 12 s for a stroke or a force with what is read and waited for, 10 s for an
/// item, 5 min for the arrival, the person, the device and the rests. For what people are told.
double expectedMinutes(const SessionSettings& settings);

/// Refuses invalid settings with one sentence. Ignores the settings of blocks that are not used.
base::Result<void> validate(const SessionSettings& settings);

/// All settings as JSON on one line. So a session continues with its own settings after a change of the defaults.
std::string toJson(const SessionSettings& settings);

/// Reads the settings that `toJson` wrote. A missing member keeps its default. Refused: other text, a member of the
/// wrong type, an unknown word.
base::Result<SessionSettings> parseSessionSettings(std::string_view text);
/// The same for settings within another JSON text.
SessionSettings readSessionSettings(base::JsonMembers& members, std::optional<base::Error>& error);

/// The seed of one block of a session: different for each block, the same for the same session.
std::uint64_t blockSeed(std::uint64_t session_seed, Block block) noexcept;

}  // namespace tactus::session
