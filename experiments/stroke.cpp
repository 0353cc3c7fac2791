#include "experiments/stroke.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/base/text.h"

namespace tactus::experiments {

void ForwardMotion::add(const PositionSample& sample) {
  if (!std::isfinite(sample.time_s) || !std::isfinite(sample.position_mm)) return;
  if (!started_) {
    started_ = true;
    block_start_ = sample;
    last_ = sample;
    return;
  }
  if (sample.time_s <= last_.time_s) return;
  last_ = sample;
  constexpr double kRoundingS = 1e-9;  // time stamps are sums of steps
  const double length_s = sample.time_s - block_start_.time_s;
  if (length_s < kBlockS - kRoundingS) return;
  const double forward_mm = sample.position_mm - block_start_.position_mm;
  if (forward_mm >= least_mm_s_ * length_s) {
    way_mm_ += forward_mm;
    moving_s_ += length_s;
  }
  block_start_ = sample;
}

namespace {

struct VerdictText {
  StrokeVerdict verdict;
  std::string_view name;
  std::string_view sentence;
};

constexpr std::array kVerdicts = {
    VerdictText{StrokeVerdict::kAccepted, "accepted", "Thank you."},
    VerdictText{StrokeVerdict::kTooShort, "too_short", "Too short: please push further forward."},
    VerdictText{StrokeVerdict::kTooBrief, "too_brief", "Too brief: the movement was over before it could be measured."},
    VerdictText{StrokeVerdict::kBackwards, "backwards", "Backwards: please push forward, away from you."},
    VerdictText{StrokeVerdict::kOutOfRange, "out_of_range",
                "Out of range: the tip left the space in which the device measures."},
    VerdictText{StrokeVerdict::kInterrupted, "interrupted", "Interrupted: part of the movement was not recorded."},
    VerdictText{StrokeVerdict::kRejected, "rejected", "Taken back: this stroke is done once more."},
};

const VerdictText& textOf(StrokeVerdict verdict) { return kVerdicts[static_cast<std::size_t>(verdict)]; }

}  // namespace

std::string_view name(StrokeVerdict verdict) noexcept { return textOf(verdict).name; }

std::optional<StrokeVerdict> strokeVerdict(std::string_view name) noexcept {
  for (const auto& text : kVerdicts) {
    if (text.name == name) return text.verdict;
  }
  return std::nullopt;
}

base::Result<void> validate(const StrokeSettings& s) {
  const auto refuse = [](std::string place, double found, std::string wanted) {
    return base::fail(base::ErrorCode::kValue, std::move(place), base::formatNumber(found), std::move(wanted));
  };
  const std::array<std::pair<const char*, double>, 10> positive = {{{"start_speed_mm_s", s.start_speed_mm_s},
                                                                    {"stop_speed_mm_s", s.stop_speed_mm_s},
                                                                    {"edge_speed_mm_s", s.edge_speed_mm_s},
                                                                    {"speed_window_s", s.speed_window_s},
                                                                    {"longest_pause_s", s.longest_pause_s},
                                                                    {"longest_reversal_mm", s.longest_reversal_mm},
                                                                    {"least_mm", s.least_mm},
                                                                    {"shortest_mm", s.shortest_mm},
                                                                    {"briefest_s", s.briefest_s},
                                                                    {"longest_gap_s", s.longest_gap_s}}};
  for (const auto& [place, value] : positive) {
    if (!std::isfinite(value) || value <= 0) return refuse(place, value, "a number above 0");
  }
  if (s.speed_window_s < 0.05 || s.speed_window_s > 0.5) {
    return refuse("speed_window_s", s.speed_window_s, "0.05 to 0.5 s");
  }
  if (s.stop_speed_mm_s >= s.start_speed_mm_s) {
    return refuse("stop_speed_mm_s", s.stop_speed_mm_s,
                  "less than start_speed_mm_s (" + base::formatNumber(s.start_speed_mm_s) + ")");
  }
  if (s.longest_reversal_mm >= s.shortest_mm) {
    return refuse("longest_reversal_mm", s.longest_reversal_mm,
                  "less than shortest_mm (" + base::formatNumber(s.shortest_mm) + ")");
  }
  if (s.least_mm > s.shortest_mm) {
    return refuse("least_mm", s.least_mm, "at most shortest_mm (" + base::formatNumber(s.shortest_mm) + ")");
  }
  if (!std::isfinite(s.lowest_mm)) return refuse("lowest_mm", s.lowest_mm, "a finite number");
  if (!std::isfinite(s.highest_mm) || s.highest_mm - s.lowest_mm < s.shortest_mm) {
    return refuse("highest_mm", s.highest_mm, "at least lowest_mm + shortest_mm");
  }
  return {};
}

std::string sentence(const Stroke& stroke, const StrokeSettings& settings) {
  const auto whole_mm = [](double value) { return base::formatFixed(std::abs(value), 0) + " mm"; };
  switch (stroke.verdict) {
    case StrokeVerdict::kTooShort:
      // Rounded down, so that it never reads "30 mm, at least 30 mm wanted".
      return "Too short: " + whole_mm(std::floor(std::max(0.0, stroke.lengthMm()))) + ", at least " +
             whole_mm(std::ceil(settings.shortest_mm)) + " wanted.";
    case StrokeVerdict::kBackwards:
      return "Backwards: " + whole_mm(stroke.lengthMm()) + " back; please push forward, away from you.";
    default: return sentence(stroke.verdict);
  }
}

std::string sentence(StrokeVerdict verdict) { return std::string(textOf(verdict).sentence); }

}  // namespace tactus::experiments
