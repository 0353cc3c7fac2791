#include "experiments/stroke_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/statistics.h"
#include "core/base/text.h"

namespace tactus::experiments {
namespace {

using study::DataFinding;
using Kind = DataFinding::Kind;
using Severity = DataFinding::Severity;

constexpr std::size_t kFewestRows = 5;
constexpr std::size_t kWindows = 8;
constexpr double kAgreement = 1.5;  // factor between change of depth and speed that rounding and filters can give
constexpr double kOddRatio = 2;     // beyond it a disagreement is worth a sentence
constexpr double kSpeedScale = 8;   // between the nurses of Table 1 it is 4 at most
constexpr double kLengthScale = 5;  // all are asked for the same stroke
constexpr double kShortMm = 8;      // no stroke that counts is shorter than 30 mm (stroke.h)
constexpr double kSlowMmS = 15;     // half of the slowest mean of Table 1
constexpr double kVerySlowMmS = 8;  // a quarter of it, where depths say nothing
constexpr double kSignShare = 0.8;  // of the rows below 0: more than a stroke with its way back has

struct Unit {
  double factor;
  std::string_view name;
};
constexpr std::array<Unit, 4> kTimes = {{{1, "s"}, {1e-3, "ms"}, {1e-6, "µs"}, {60, "minutes"}}};
constexpr std::array<Unit, 5> kDepths = {{{1, "mm"}, {10, "cm"}, {1000, "m"}, {1e-3, "µm"}, {25.4, "inches"}}};
constexpr std::array<Unit, 7> kSpeeds = {{{1, "mm/s"},
                                          {10, "cm/s"},
                                          {1000, "m/s"},
                                          {25.4, "inches/s"},
                                          {1000.0 / 60, "m/min"},
                                          {1e6 / 3600, "km/h"},
                                          {0.1, "mm/s without their decimal point"}}};

struct Range {
  double least, most;
  bool holds(double value) const { return value >= least && value <= most; }
};
constexpr Range kStrokeS = {0.05, 120};
constexpr Range kStrokeMm = {3, 1000};
constexpr Range kStrokeMmS = {1, 2000};
// Where several units fit, the one that gives a stroke as the experiment asks for it.
constexpr Range kUsualMm = {20, 250};
constexpr Range kUsualMmS = {15, 800};

/// What one stroke says of its units. Medians, so that single wrong cells do not count.
struct Extent {
  double time_s = 0;
  double depth_mm = 0;    // never negative
  double speed_mm_s = 0;  // never negative
  double ratio = 0;       // change of depth / sum of speed times time
};

std::optional<Extent> extentOf(const TableStroke& stroke) {
  const auto& rows = stroke.in_time;
  if (rows.size() < kFewestRows) return std::nullopt;
  std::vector<double> speeds;
  std::vector<double> steps;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    speeds.push_back(std::abs(rows[i]->speed_mm_s));
    if (i > 0) steps.push_back(rows[i]->time_s - rows[i - 1]->time_s);
  }
  const std::size_t windows = std::min(kWindows, rows.size() - 1);
  std::vector<double> ratios;
  std::vector<double> ways;
  for (std::size_t w = 0; w < windows; ++w) {
    const std::size_t first = w * (rows.size() - 1) / windows;
    const std::size_t last = (w + 1) * (rows.size() - 1) / windows;
    double way = 0;
    for (std::size_t i = first; i < last; ++i) {
      way += 0.5 * (rows[i]->speed_mm_s + rows[i + 1]->speed_mm_s) * (rows[i + 1]->time_s - rows[i]->time_s);
    }
    const double depth = rows[last]->depth_mm - rows[first]->depth_mm;
    ways.push_back(std::abs(depth));
    if (way != 0) ratios.push_back(depth / way);
  }
  Extent extent;
  extent.time_s = base::median(steps) * static_cast<double>(steps.size());
  extent.depth_mm = base::median(ways) * static_cast<double>(windows);
  extent.speed_mm_s = base::median(speeds);
  if (ratios.empty() || extent.time_s <= 0 || extent.depth_mm <= 0 || extent.speed_mm_s <= 0) return std::nullopt;
  extent.ratio = base::median(ratios);
  return extent;
}

bool agrees(double ratio) { return std::abs(ratio) >= 1 / kAgreement && std::abs(ratio) <= kAgreement; }

bool fits(const Extent& extent, const UnitFactors& by) {
  return kStrokeS.holds(extent.time_s * by.time) && kStrokeMm.holds(extent.depth_mm * by.depth) &&
         kStrokeMmS.holds(extent.speed_mm_s * by.speed) && agrees(extent.ratio * by.depth / (by.speed * by.time));
}

int changed(const UnitFactors& by) {
  return (by.time != 1 ? 1 : 0) + (by.depth != 1 ? 1 : 0) + (by.speed != 1 ? 1 : 0);
}

/// The other units that make the stroke fit, with as few columns changed as can be.
std::vector<UnitFactors> otherUnits(const Extent& extent) {
  std::vector<UnitFactors> found;
  int least = 4;
  for (const auto& time : kTimes) {
    for (const auto& depth : kDepths) {
      for (const auto& speed : kSpeeds) {
        const UnitFactors by{time.factor, depth.factor, speed.factor};
        const int columns = changed(by);
        if (columns == 0 || columns > least || !fits(extent, by)) continue;
        if (columns < least) found.clear();
        least = columns;
        found.push_back(by);
      }
    }
  }
  if (found.size() < 2) return found;
  std::vector<UnitFactors> usual;
  for (const auto& by : found) {
    if (kUsualMm.holds(extent.depth_mm * by.depth) && kUsualMmS.holds(extent.speed_mm_s * by.speed))
      usual.push_back(by);
  }
  return usual;
}

template <std::size_t Count>
std::string_view unitName(const std::array<Unit, Count>& units, double factor) {
  return std::find_if(units.begin(), units.end(), [factor](const Unit& unit) { return unit.factor == factor; })->name;
}

/// `multiply speed_mm_s by 10`, `divide time_s by 1000`.
std::string conversion(std::string_view column, double factor) {
  if (factor < 1) return "divide " + std::string(column) + " by " + base::formatNumber(std::round(1 / factor));
  return "multiply " + std::string(column) + " by " + base::formatNumber(std::round(factor * 1e3) / 1e3);
}

struct Column {
  Kind kind;
  std::string_view name, what, unit;
  double factor;
};

std::vector<Column> wrongColumns(const UnitFactors& by) {
  std::vector<Column> out;
  if (by.time != 1) out.push_back({Kind::kTimeUnit, "time_s", "times", unitName(kTimes, by.time), by.time});
  if (by.depth != 1) out.push_back({Kind::kDepthUnit, "depth_mm", "depths", unitName(kDepths, by.depth), by.depth});
  if (by.speed != 1) out.push_back({Kind::kSpeedUnit, "speed_mm_s", "speeds", unitName(kSpeeds, by.speed), by.speed});
  return out;
}

using Strokes = std::vector<const TableStroke*>;

/// Refused only where all strokes of the participant say the same: a single short stroke may be true.
DataFinding unitFinding(const UnitFactors& by, const Strokes& strokes, std::size_t of) {
  const auto columns = wrongColumns(by);
  const std::string who(strokes.front()->participant);
  std::vector<std::string> looks;
  std::vector<std::string> remedies;
  for (const auto& column : columns) {
    looks.push_back("the " + std::string(column.what) + " look like " + std::string(column.unit));
    remedies.push_back(conversion(column.name, column.factor));
  }
  const auto& row = *strokes.front()->rows.front();
  const Kind kind = columns.size() == 1 ? columns.front().kind : Kind::kSeveralUnits;
  DataFinding finding =
      study::refusal(kind, who, {study::kSpeedsTable, row.line, columns.front().name},
                     "in " + strokesText(strokes, of) + " of " + who + " " + base::joined(looks, " and "),
                     base::joined(remedies, ", ") + " there, so that s, mm and mm/s fit each other");
  if (strokes.size() == of) return finding;
  finding.severity = Severity::kWarning;
  finding.found.clear();
  finding.wanted.clear();
  return finding;
}

/// By how much the mean speed of the stroke lies above the change of its depth over its time; nothing where the times
/// do not say.
std::optional<double> offsetOf(const TableStroke& stroke) {
  const auto& rows = stroke.in_time;
  if (rows.size() < kFewestRows) return std::nullopt;
  const double length_s = rows.back()->time_s - rows.front()->time_s;
  if (!(length_s > 0) || rows.back()->depth_mm == rows.front()->depth_mm) return std::nullopt;
  double way_mm = 0;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    way_mm += 0.5 * (rows[i]->speed_mm_s + rows[i + 1]->speed_mm_s) * (rows[i + 1]->time_s - rows[i]->time_s);
  return (way_mm - (rows.back()->depth_mm - rows.front()->depth_mm)) / length_s;
}

/// The same constant on the speeds of all strokes: slow and fast ones are as far off, which no unit explains.
void addOffset(std::span<const TableStroke* const> all, std::vector<DataFinding>& out) {
  constexpr std::size_t kFewest = 4;
  constexpr double kLeastMmS = 5;
  constexpr double kAlike = 0.25;
  std::vector<double> offsets;
  for (const auto* stroke : all) {
    if (const auto offset = offsetOf(*stroke)) offsets.push_back(*offset);
  }
  if (offsets.size() < kFewest || offsets.size() < all.size()) return;
  const double usual = base::median(offsets);
  if (std::abs(usual) < kLeastMmS) return;
  const bool alike = std::all_of(offsets.begin(), offsets.end(),
                                 [&](double one) { return std::abs(one - usual) <= kAlike * std::abs(usual); });
  if (!alike) return;
  const std::string who(all.front()->participant);
  out.push_back({Kind::kSpeedAgainstDepth,
                 Severity::kWarning,
                 who,
                 {study::kSpeedsTable, all.front()->line(), "speed_mm_s"},
                 "The speeds of " + who + " lie " + base::formatFixed(std::abs(usual), 1) + " mm/s " +
                     (usual > 0 ? "above" : "below") +
                     " what the depths and times say, alike in all strokes: a constant was added, or a zero is off.",
                 {},
                 {}});
}

void addSigns(std::span<const TableStroke* const> all, std::span<const UnitFit> fits, std::vector<DataFinding>& out) {
  const std::size_t of = all.size();
  Strokes wrong_sign;
  Strokes falling;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto* stroke = all[i];
    const auto& rows = stroke->in_time;
    const auto below = std::count_if(rows.begin(), rows.end(), [](const auto* row) { return row->speed_mm_s < 0; });
    const bool negative = static_cast<double>(below) > kSignShare * static_cast<double>(rows.size());
    if (negative) {
      wrong_sign.push_back(stroke);
    } else if (fits[i].depth_over_speed < 0) {
      falling.push_back(stroke);
    }
  }
  const auto cell = [](const Strokes& strokes, std::string_view column) {
    return study::TableCell{study::kSpeedsTable, strokes.front()->line(), column};
  };
  const std::string who(all.front()->participant);
  if (!wrong_sign.empty()) {
    out.push_back(study::refusal(Kind::kSpeedSign, who, cell(wrong_sign, "speed_mm_s"),
                                 "in " + strokesText(wrong_sign, of) + " of " + who + " most speeds are below 0",
                                 "turn the sign of speed_mm_s, or take withdrawals out: a stroke goes forward, and "
                                 "forward is above 0"));
  }
  if (!falling.empty()) {
    out.push_back({Kind::kDepthFalls,
                   Severity::kWarning,
                   who,
                   cell(falling, "depth_mm"),
                   "In " + strokesText(falling, of) + " of " + who +
                       " the depth falls while the speed is above 0: depths count from 0 inward.",
                   {},
                   {}});
  }
}

/// What the strokes of one participant are like: medians, 0 where nothing can be said.
struct Scale {
  double speed_mm_s = 0;
  double length_mm = 0;
};

Scale scaleOf(const Strokes& strokes) {
  std::vector<double> speeds;
  std::vector<double> lengths;
  for (const auto* stroke : strokes) {
    for (const auto* row : stroke->rows) speeds.push_back(std::abs(row->speed_mm_s));
    if (const auto extent = extentOf(*stroke)) lengths.push_back(extent->depth_mm);
  }
  return {base::median(std::move(speeds)), lengths.empty() ? 0 : base::median(std::move(lengths))};
}

/// Whether a value of the participant `i` is `factor` times that of every other one, two or more, or that part of it.
bool standsOut(std::span<const Scale> scales, std::size_t i, double Scale::*value, double factor) {
  const double own = scales[i].*value;
  std::size_t others = 0;
  bool above_all = true;
  bool below_all = true;
  for (std::size_t k = 0; k < scales.size(); ++k) {
    const double other = scales[k].*value;
    if (k == i || other <= 0) continue;
    ++others;
    above_all = above_all && own > factor * other;
    below_all = below_all && own * factor < other;
  }
  return own > 0 && others >= 2 && (above_all || below_all);
}

/// What the times alone say where depths cannot: a stroke of minutes is one of milliseconds.
UnitFit timeFit(const TableStroke& stroke) {
  const auto& rows = stroke.in_time;
  if (rows.size() < kFewestRows) return {};
  const double length_s = rows.back()->time_s - rows.front()->time_s;
  if (length_s <= kStrokeS.most || !kStrokeS.holds(1e-3 * length_s)) return {};
  return {UnitFit::Verdict::kOther, {1e-3, 1, 1}, 1};
}

}  // namespace

UnitFit unitFit(const TableStroke& stroke) {
  const auto extent = extentOf(stroke);
  if (!extent) return timeFit(stroke);
  UnitFit fit{UnitFit::Verdict::kNeither, {}, extent->ratio};
  if (agrees(extent->ratio)) fit.verdict = UnitFit::Verdict::kFits;
  // A very short way is no reason to doubt columns that agree.
  const bool possible = kStrokeS.holds(extent->time_s) && kStrokeMmS.holds(extent->speed_mm_s);
  if (agrees(extent->ratio) && possible) return fit;
  const auto others = otherUnits(*extent);
  if (others.size() == 1) {
    fit.verdict = UnitFit::Verdict::kOther;
    fit.factors = others.front();
  }
  return fit;
}

std::vector<DataFinding> unitFindings(std::span<const TableStroke* const> strokes) {
  std::vector<DataFinding> out;
  std::map<std::tuple<double, double, double>, Strokes> other;
  Strokes odd;
  std::vector<double> odd_ratios;
  std::vector<UnitFit> fits;
  for (const auto* stroke : strokes) {
    const auto fit = fits.emplace_back(unitFit(*stroke));
    if (fit.verdict == UnitFit::Verdict::kOther) {
      other[{fit.factors.time, fit.factors.depth, fit.factors.speed}].push_back(stroke);
    } else if (fit.verdict == UnitFit::Verdict::kNeither) {
      const double ratio = std::abs(fit.depth_over_speed);
      if (ratio <= kOddRatio && ratio >= 1 / kOddRatio) continue;
      odd.push_back(stroke);
      odd_ratios.push_back(ratio);
    }
  }
  std::vector<Kind> said;
  for (const auto& [factors, concerned] : other) {
    const auto& [time, depth, speed] = factors;
    auto finding = unitFinding({time, depth, speed}, concerned, strokes.size());
    if (std::find(said.begin(), said.end(), finding.kind) != said.end()) continue;
    said.push_back(finding.kind);
    out.push_back(std::move(finding));
  }
  if (!odd.empty()) {
    const std::string who(odd.front()->participant);
    out.push_back({Kind::kSpeedAgainstDepth,
                   Severity::kWarning,
                   who,
                   {study::kSpeedsTable, odd.front()->line(), "speed_mm_s"},
                   "In " + strokesText(odd, strokes.size()) + " of " + who + " the depths change " +
                       base::formatFixed(base::median(odd_ratios), 2) +
                       " times as fast as speed_mm_s says: one of the columns is not what its name says.",
                   {},
                   {}});
  }
  const bool all_fit =
      std::all_of(fits.begin(), fits.end(), [](const UnitFit& fit) { return fit.verdict != UnitFit::Verdict::kOther; });
  if (all_fit && odd.empty()) addOffset(strokes, out);
  addSigns(strokes, fits, out);
  return out;
}

std::vector<DataFinding> scaleFindings(std::span<const std::vector<const TableStroke*>> participants) {
  std::vector<Scale> scales;
  for (const auto& strokes : participants) scales.push_back(scaleOf(strokes));
  std::vector<DataFinding> out;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const auto& strokes = participants[i];
    const auto& own = scales[i];
    const std::string who(strokes.front()->participant);
    const bool short_and_slow =
        own.length_mm > 0 ? own.length_mm < kShortMm && own.speed_mm_s < kSlowMmS : own.speed_mm_s < kVerySlowMmS;
    const auto beyond = [&](double Scale::*value, double factor) { return standsOut(scales, i, value, factor); };
    const bool other_length = beyond(&Scale::length_mm, kLengthScale);
    if (!short_and_slow && !other_length && !beyond(&Scale::speed_mm_s, kSpeedScale)) continue;
    std::string sentence =
        "Half of the speeds of " + who + " lie below " + base::formatFixed(own.speed_mm_s, 1) + " mm/s";
    if (own.length_mm > 0) sentence += " and the strokes are " + base::formatFixed(own.length_mm, 1) + " mm long";
    sentence += short_and_slow && !other_length ? "" : ", quite unlike the other participants";
    out.push_back({Kind::kSpeedScale,
                   Severity::kWarning,
                   who,
                   {study::kSpeedsTable, strokes.front()->line(), "speed_mm_s"},
                   sentence + ": other units in both columns?",
                   {},
                   {}});
  }
  return out;
}

}  // namespace tactus::experiments
