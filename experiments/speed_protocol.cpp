#include "experiments/speed_protocol.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "experiments/seeded_order.h"

namespace tactus::experiments {
namespace {

constexpr std::string_view kLevelsBlock = "speed/levels";

/// What was wrong with a recorded stroke, with its length where the positions are known.
std::string reasonOf(const study::StrokeRecord& record, StrokeVerdict verdict, const StrokeSettings& settings) {
  for (const auto& channel : record.recording.channels) {
    if (channel.name != "depth" || record.first >= record.last || record.last > channel.values.size()) continue;
    Stroke stroke;
    stroke.start_mm = channel.values[record.first];
    stroke.end_mm = channel.values[record.last - 1];
    stroke.verdict = verdict;
    return sentence(stroke, settings);
  }
  return sentence(verdict);
}

}  // namespace

base::Result<void> validate(const SpeedSettings& settings) {
  const auto refuse = [](std::string place, std::string found, std::string wanted) {
    return base::fail(base::ErrorCode::kValue, std::move(place), std::move(found), std::move(wanted));
  };
  if (settings.levels.empty()) return refuse("levels", "none", "at least one level");
  std::set<std::string> seen;
  for (const auto& level : settings.levels) {
    if (level.empty()) return refuse("levels", "an empty name", "term ids");
    if (!seen.insert(level).second) return refuse("levels", base::quoted(level) + " twice", "each level once");
  }
  if (settings.strokes < 1 || settings.strokes > 50) {
    return refuse("strokes", std::to_string(settings.strokes), "1 to 50");
  }
  if (settings.practice < 0 || settings.practice > 20) {
    return refuse("practice", std::to_string(settings.practice), "0 to 20");
  }
  if (settings.latin_row < 0) return refuse("latin_row", std::to_string(settings.latin_row), "0 or more");
  return validate(settings.stroke);
}

// For an even number of levels n the rows 0 to n - 1 do; an odd one needs them backwards too.
std::vector<std::size_t> williamsRow(std::size_t levels, std::size_t row) {
  const std::size_t rows = levels % 2 == 0 ? levels : 2 * levels;
  row %= rows;
  std::vector<std::size_t> out(levels);
  for (std::size_t place = 0; place < levels; ++place) {
    // The first row is 0, 1, n - 1, 2, n - 2, ...
    const std::size_t first = place % 2 == 1 ? (place + 1) / 2 : (levels - place / 2) % levels;
    out[place] = (first + row) % levels;
  }
  if (row >= levels) std::reverse(out.begin(), out.end());
  return out;
}

base::Result<SpeedProtocol> SpeedProtocol::create(const SpeedSettings& settings, std::uint64_t seed,
                                                  std::span<const study::StrokeRecord> records) {
  if (auto valid = validate(settings); !valid) return tl::unexpected(valid.error());
  SpeedSettings used = settings;
  if (!used.counts) {
    used.practice = std::max(1, used.strokes);
    used.strokes = 0;
  }
  SpeedProtocol protocol(used, seed);
  for (const auto& record : records) {
    if (auto added = protocol.add(record); !added) return tl::unexpected(added.error());
  }
  return protocol;
}

SpeedProtocol::SpeedProtocol(const SpeedSettings& settings, std::uint64_t seed)
    : settings_(settings), levels_(settings.levels) {
  if (settings.order == SpeedSettings::Order::kShuffled) {
    base::Random random(blockSeed(seed, kLevelsBlock));
    levels_ = shuffled(std::move(levels_), random);
  }
  if (settings.order == SpeedSettings::Order::kLatinSquare) {
    const auto row = williamsRow(settings.levels.size(), static_cast<std::size_t>(settings.latin_row));
    for (std::size_t place = 0; place < row.size(); ++place) levels_[place] = settings.levels[row[place]];
  }
}

SpeedPlan SpeedProtocol::next() const {
  SpeedPlan plan;
  plan.level_count = static_cast<int>(levels_.size());
  plan.wanted = plan.level_count * settings_.strokes;
  plan.accepted = static_cast<int>(std::count_if(attempts_.begin(), attempts_.end(), [](const Attempt& attempt) {
    return !attempt.slot.practice && attempt.verdict == StrokeVerdict::kAccepted;
  }));
  const auto slot = nextSlot();
  if (!slot) {
    plan.finished = true;
    return plan;
  }
  plan.level = levels_[slot->level];
  plan.level_place = static_cast<int>(slot->level) + 1;
  plan.practice = slot->practice;
  plan.number = slot->number;
  plan.count = slot->practice ? settings_.practice : settings_.strokes;
  plan.attempt = attemptsAt(*slot) + 1;
  for (const auto& attempt : attempts_) {
    if (attempt.slot != *slot) continue;
    plan.repeat_reason = attempt.reason;
    plan.repeat = attempt.verdict;
  }
  return plan;
}

study::StrokeRecord SpeedProtocol::record(const Stroke& stroke, study::Recording recording,
                                          std::size_t recording_first) const {
  const SpeedPlan plan = next();
  TACTUS_CHECK(!plan.finished && stroke.first >= recording_first && stroke.last <= recording_first + recording.size());
  study::StrokeRecord record;
  record.level = plan.level;
  record.number = plan.number;
  record.attempt = plan.attempt;
  record.practice = plan.practice;
  record.verdict = name(stroke.verdict);
  record.first = stroke.first - recording_first;
  record.last = stroke.last - recording_first;
  record.recording = std::move(recording);
  return record;
}

base::Result<void> SpeedProtocol::add(const study::StrokeRecord& record) {
  TACTUS_TRY(auto attempt, read(record));
  const auto refuse = [&](std::string found, std::string wanted) {
    return base::fail(base::ErrorCode::kData, "stroke " + study::toText(record.entry.id), std::move(found),
                      std::move(wanted));
  };
  if (record.entry.supersedes) {
    const auto corrected = std::find_if(attempts_.begin(), attempts_.end(),
                                        [&](const Attempt& earlier) { return earlier.id == *record.entry.supersedes; });
    if (corrected == attempts_.end()) return refuse("a correction of an unknown stroke", "one of this session");
    if (corrected->slot != attempt.slot || corrected->attempt != attempt.attempt) {
      return refuse("a correction with another level, number or attempt", "those of the stroke that it corrects");
    }
    *corrected = std::move(attempt);
    return {};
  }
  const auto slot = nextSlot();
  if (!slot) return refuse("one more stroke", "none: the speed experiment is finished");
  const int number = attemptsAt(*slot) + 1;
  if (attempt.slot != *slot || attempt.attempt != number) {
    return refuse(record.level + (record.practice ? ", practice " : ", stroke ") + std::to_string(record.number) +
                      ", attempt " + std::to_string(record.attempt),
                  levels_[slot->level] + (slot->practice ? ", practice " : ", stroke ") + std::to_string(slot->number) +
                      ", attempt " + std::to_string(number));
  }
  attempts_.push_back(std::move(attempt));
  return {};
}

std::optional<SpeedProtocol::Slot> SpeedProtocol::nextSlot() const {
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    for (const bool practice : {true, false}) {
      const int count = practice ? settings_.practice : settings_.strokes;
      for (int number = 1; number <= count; ++number) {
        const Slot slot{level, practice, number};
        if (!isAccepted(slot)) return slot;
      }
    }
  }
  return std::nullopt;
}

bool SpeedProtocol::isAccepted(const Slot& slot) const {
  return std::any_of(attempts_.begin(), attempts_.end(), [&](const Attempt& attempt) {
    return attempt.slot == slot && attempt.verdict == StrokeVerdict::kAccepted;
  });
}

int SpeedProtocol::attemptsAt(const Slot& slot) const {
  return static_cast<int>(
      std::count_if(attempts_.begin(), attempts_.end(), [&](const Attempt& attempt) { return attempt.slot == slot; }));
}

base::Result<SpeedProtocol::Attempt> SpeedProtocol::read(const study::StrokeRecord& record) const {
  const std::string place = "stroke " + study::toText(record.entry.id);
  const auto level = std::find(levels_.begin(), levels_.end(), record.level);
  if (level == levels_.end()) {
    return base::fail(base::ErrorCode::kReference, place, "the level " + base::quoted(record.level),
                      "a level of the settings");
  }
  const auto verdict = strokeVerdict(record.verdict);
  if (!verdict) {
    return base::fail(base::ErrorCode::kValue, place, "the verdict " + base::quoted(record.verdict), "a known verdict");
  }
  const bool accepted = *verdict == StrokeVerdict::kAccepted;
  return Attempt{record.entry.id,
                 {static_cast<std::size_t>(level - levels_.begin()), record.practice, record.number},
                 record.attempt,
                 *verdict,
                 accepted ? std::string() : reasonOf(record, *verdict, settings_.stroke)};
}

}  // namespace tactus::experiments
