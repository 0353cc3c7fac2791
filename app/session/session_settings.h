// What a session consists of and how each block is run, and its text in the study file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "experiments/force_series.h"
#include "experiments/speed_protocol.h"
#include "questionnaires/item_order.h"

namespace tactus::session {

/// One part of a session. After each of them the participant rates effort and comfort.
enum class Block { kSpeed, kForce, kForm };

/// `speed`, `force`, `form`.
std::string_view name(Block block) noexcept;

struct SessionSettings {
  std::vector<Block> blocks = {Block::kSpeed, Block::kForce, Block::kForm};  ///< each at most once
  experiments::SpeedSettings speed;
  experiments::ForceSettings force;
  std::string form = "ngt-force-v1";
  questionnaires::ItemOrder item_order = questionnaires::ItemOrder::kFixed;
};

/// The session of a clinical teacher who tried the simulator: the usability form alone (paper, Section 5.4).
SessionSettings usabilitySession();

/// Refuses settings that make no sense, with one sentence. Settings of blocks that are not used are not looked at.
base::Result<void> validate(const SessionSettings& settings);

/// All settings as JSON on one line, so that a session goes on as it began even where defaults have changed since.
std::string toJson(const SessionSettings& settings);

/// The settings that `toJson` wrote. A missing member keeps its default; refused: text that is no such JSON, a member
/// of another type, an unknown word.
base::Result<SessionSettings> parseSessionSettings(std::string_view text);

/// The seed of one block of a session: another for each block, the same for the same session.
std::uint64_t blockSeed(std::uint64_t session_seed, Block block) noexcept;

}  // namespace tactus::session
