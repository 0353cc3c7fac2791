#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/base/statistics.h"
#include "core/base/text.h"
#include "experiments/table_findings.h"

namespace tactus::experiments {
namespace {

using study::DataFinding;
using Kind = DataFinding::Kind;
using Severity = DataFinding::Severity;
using Strokes = std::vector<const TableStroke*>;

constexpr double kOutlier = 5;  // times the 95 % quantile; a plateau with ramps has 1.5 at most
constexpr std::size_t kFewestRowsJudged = 5;
constexpr double kBackMm = 5;
constexpr double kBackMmS = -10;
constexpr double kSpikeMm = 50;     // between rows a few ms apart
constexpr double kAcceptedMm = 30;  // a shorter stroke of a session is asked for again (stroke.h)
constexpr double kGapS = 0.05;      // without a sample; the same
constexpr double kGapSteps = 5;     // of the table's own steps
constexpr std::array<double, 6> kMissingCodes = {-99, -999, -9999, 999, 9999, 99999};

DataFinding finding(Kind kind, Severity severity, const study::SpeedSample& row, std::string_view column,
                    std::string sentence) {
  return {kind, severity, row.participant, {study::kSpeedsTable, row.line, column}, std::move(sentence), {}, {}};
}

std::map<std::string_view, Strokes> byLevel(std::span<const TableStroke* const> strokes) {
  std::map<std::string_view, Strokes> levels;
  for (const auto* stroke : strokes) levels[stroke->level].push_back(stroke);
  return levels;
}

bool constantSpeed(const TableStroke& stroke) {
  const auto& rows = stroke.rows;
  return rows.size() >= kFewestRowsJudged && std::all_of(rows.begin(), rows.end(), [&rows](const auto* row) {
           return row->speed_mm_s == rows.front()->speed_mm_s;
         });
}

bool constantDepth(const TableStroke& stroke) {
  const auto& rows = stroke.rows;
  return rows.size() >= kFewestRowsJudged && std::all_of(rows.begin(), rows.end(), [&rows](const auto* row) {
           return row->depth_mm == rows.front()->depth_mm;
         });
}

/// A single depth far from both its neighbors in time.
bool isSpike(const std::vector<const study::SpeedSample*>& rows, std::size_t i) {
  if (i == 0 || i + 1 >= rows.size()) return false;
  const double before = rows[i]->depth_mm - rows[i - 1]->depth_mm;
  const double after = rows[i]->depth_mm - rows[i + 1]->depth_mm;
  return std::min(std::abs(before), std::abs(after)) > kSpikeMm && before * after > 0;
}

/// The depth falls by kBackMm after it has risen, or the speed stays below 0 for a while. Strokes that go backwards as
/// a whole are of another kind (stroke_units.h).
bool goesBack(const TableStroke& stroke) {
  const auto& rows = stroke.in_time;
  std::size_t below = 0;
  std::size_t run = 0;
  std::size_t longest = 0;
  double run_sum_mm_s = 0;
  double deepest_mm = rows.front()->depth_mm;
  double back_mm = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto* row = rows[i];
    if (isSpike(rows, i)) continue;
    const bool is_below = row->speed_mm_s < 0;
    if (is_below) ++below;
    run = is_below ? run + 1 : 0;
    run_sum_mm_s = is_below ? run_sum_mm_s + row->speed_mm_s : 0;
    if (run_sum_mm_s < kBackMmS * static_cast<double>(run)) longest = std::max(longest, run);
    deepest_mm = std::max(deepest_mm, row->depth_mm);
    back_mm = std::max(back_mm, deepest_mm - row->depth_mm);
  }
  const bool came_from_less = deepest_mm - rows.front()->depth_mm > kBackMm;
  const bool runs_back = longest >= kFewestRowsJudged && 20 * longest >= rows.size();
  // Where nearly all speeds are below 0, the sign is wrong (stroke_units.h).
  return 5 * below <= 4 * rows.size() && (runs_back || (back_mm > kBackMm && came_from_less));
}

void addNamed(Kind kind, Severity severity, std::string_view column, const std::string& says, const Strokes& concerned,
              std::size_t of, std::vector<DataFinding>& out) {
  if (concerned.empty()) return;
  const auto& row = *concerned.front()->rows.front();
  out.push_back(
      finding(kind, severity, row, column, "In " + strokesText(concerned, of) + " of " + row.participant + ' ' + says));
}

bool isMissingCode(double value) {
  return std::find(kMissingCodes.begin(), kMissingCodes.end(), value) != kMissingCodes.end();
}

/// The rows of a level whose speed is far beyond the others', first row first.
std::vector<const study::SpeedSample*> outliersOf(const Strokes& strokes, double& usual_mm_s) {
  std::vector<double> speeds;
  for (const auto* stroke : strokes) {
    for (const auto* row : stroke->rows) speeds.push_back(std::abs(row->speed_mm_s));
  }
  usual_mm_s = base::quantile(speeds, 0.95);
  std::vector<const study::SpeedSample*> out;
  if (speeds.size() < 4 * kFewestRowsJudged || usual_mm_s <= 0) return out;
  for (const auto* stroke : strokes) {
    for (const auto* row : stroke->rows) {
      const double speed = std::abs(row->speed_mm_s);
      const bool code = isMissingCode(row->speed_mm_s) && (row->speed_mm_s < 0 || speed > 2 * usual_mm_s);
      if (speed > kOutlier * usual_mm_s || code) out.push_back(row);
    }
  }
  return out;
}

void addOutliers(std::span<const TableStroke* const> strokes, std::vector<DataFinding>& out) {
  std::optional<DataFinding> worst;
  std::size_t count = 0;
  for (const auto& [level, of_level] : byLevel(strokes)) {
    double usual_mm_s = 0;
    const auto rows = outliersOf(of_level, usual_mm_s);
    if (rows.empty()) continue;
    count += rows.size();
    if (worst) continue;
    const auto& row = *rows.front();
    worst = finding(
        Kind::kOutliers, Severity::kWarning, row, "speed_mm_s",
        "A speed of " + row.participant + " at " + std::string(level) + " is " + base::formatNumber(row.speed_mm_s) +
            " mm/s, where 95 % lie below " + base::formatFixed(usual_mm_s, 0) +
            " mm/s: " + (isMissingCode(row.speed_mm_s) ? "a code for a missing value?" : "a misplaced decimal point?"));
  }
  for (const auto* stroke : strokes) {
    for (std::size_t i = 0; i < stroke->in_time.size(); ++i) {
      if (!isSpike(stroke->in_time, i)) continue;
      ++count;
      const auto& row = *stroke->in_time[i];
      if (!worst) {
        worst = finding(Kind::kOutliers, Severity::kWarning, row, "depth_mm",
                        "A depth of " + row.participant + " in " + stroke->name() + " is " +
                            base::formatNumber(row.depth_mm) + " mm, more than " + base::formatFixed(kSpikeMm, 0) +
                            " mm from the rows before and after it: a misplaced decimal point?");
      }
    }
  }
  if (!worst) return;
  if (count > 1) worst->sentence += " There are " + std::to_string(count) + " such rows.";
  out.push_back(std::move(*worst));
}

double meanSpeed(const Strokes& strokes) {
  std::vector<double> speeds;
  for (const auto* stroke : strokes) {
    for (const auto* row : stroke->rows) speeds.push_back(row->speed_mm_s);
  }
  return base::mean(speeds);
}

void addSwapped(const std::map<std::string_view, Strokes>& found, std::span<const std::string> levels,
                std::vector<DataFinding>& out) {
  const std::string* slower = nullptr;
  for (const auto& level : levels) {
    const auto here = found.find(level);
    if (here == found.end()) continue;
    if (slower != nullptr && meanSpeed(here->second) < 0.9 * meanSpeed(found.at(*slower))) {
      const auto& row = *here->second.front()->rows.front();
      out.push_back(finding(Kind::kLevelsSwapped, Severity::kWarning, row, "level",
                            "The strokes of " + row.participant + " at " + level + " are slower than those at " +
                                *slower + " (" + base::formatFixed(meanSpeed(here->second), 1) + " against " +
                                base::formatFixed(meanSpeed(found.at(*slower)), 1) + " mm/s): swapped?"));
      return;
    }
    slower = &level;
  }
}

/// The way forward, from the first row to the last.
double lengthOf(const TableStroke& stroke) {
  return stroke.in_time.back()->depth_mm - stroke.in_time.front()->depth_mm;
}

/// Whether samples are missing in the middle: a step much longer than the others.
bool hasGap(const TableStroke& stroke) {
  const auto& rows = stroke.in_time;
  if (rows.size() < 2 * kFewestRowsJudged) return false;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < rows.size(); ++i) steps_s.push_back(rows[i]->time_s - rows[i - 1]->time_s);
  const double longest_s = *std::max_element(steps_s.begin(), steps_s.end());
  return longest_s > std::max(kGapS, kGapSteps * base::median(std::move(steps_s)));
}

/// Strokes that a session would not accept because of their length, where the others of the participant are longer.
Strokes shortStrokes(std::span<const TableStroke* const> strokes) {
  std::vector<double> lengths;
  for (const auto* stroke : strokes) lengths.push_back(lengthOf(*stroke));
  const double usual_mm = base::median(std::move(lengths));
  Strokes out;
  for (const auto* stroke : strokes) {
    const double length_mm = lengthOf(*stroke);
    if (length_mm > 0 && length_mm < kAcceptedMm && 2 * length_mm < usual_mm) out.push_back(stroke);
  }
  return out;
}

}  // namespace

std::vector<DataFinding> valueFindings(std::span<const TableStroke* const> strokes) {
  Strokes constant;
  Strokes without_depth;
  Strokes back;
  Strokes gaps;
  for (const auto* stroke : strokes) {
    if (constantSpeed(*stroke)) constant.push_back(stroke);
    if (constantDepth(*stroke)) without_depth.push_back(stroke);
    if (goesBack(*stroke)) back.push_back(stroke);
    if (hasGap(*stroke)) gaps.push_back(stroke);
  }
  std::vector<DataFinding> out;
  const std::size_t of = strokes.size();
  addNamed(Kind::kConstantSpeed, Severity::kWarning, "speed_mm_s",
           "the speed is one number from the first row to the last: a mean instead of samples?", constant, of, out);
  addNamed(Kind::kNoDepths, Severity::kNote, "depth_mm",
           "the depth does not change, so whether the speeds fit it cannot be seen.", without_depth, of, out);
  addNamed(Kind::kWithdrawal, Severity::kWarning, "speed_mm_s",
           "the hand goes back: a withdrawal in the stroke, whose speeds below 0 are clustered too.", back, of, out);
  addNamed(Kind::kStrokeTooShort, Severity::kNote, "depth_mm",
           "the way is under 30 mm and half of what it is otherwise: stopped early?", shortStrokes(strokes), of, out);
  addNamed(Kind::kSamplesMissing, Severity::kNote, "time_s",
           "samples are missing: more than 0.05 s and five steps without one.", gaps, of, out);
  addOutliers(strokes, out);
  return out;
}

std::size_t usualStrokes(std::span<const TableStroke> strokes) {
  std::map<std::pair<std::string_view, std::string_view>, std::size_t> counts;
  for (const auto& stroke : strokes) ++counts[{stroke.participant, stroke.level}];
  std::map<std::size_t, std::size_t> how_often;
  for (const auto& [who, count] : counts) ++how_often[count];
  std::size_t usual = 0;
  for (const auto& [count, often] : how_often) {
    if (usual == 0 || often >= how_often[usual]) usual = count;
  }
  return usual;
}

std::vector<DataFinding> levelFindings(std::span<const TableStroke* const> strokes, std::span<const std::string> levels,
                                       std::size_t usual) {
  std::vector<DataFinding> out;
  const auto found = byLevel(strokes);
  const auto& first = *strokes.front()->rows.front();
  for (const auto* stroke : strokes) {
    if (std::find(levels.begin(), levels.end(), stroke->level) != levels.end()) continue;
    const auto& row = *stroke->rows.front();
    const std::string wanted = "one of " + base::joined(levels, ", ") + base::suggestion(stroke->level, levels);
    out.push_back({Kind::kUnknownLevel,
                   Severity::kRefused,
                   row.participant,
                   {study::kSpeedsTable, row.line, "level"},
                   "The level " + base::quoted(stroke->level) + " of " + row.participant + " is not " + wanted + '.',
                   base::quoted(stroke->level),
                   wanted});
    return out;
  }
  std::vector<std::string> without;
  std::vector<std::string> fewer;
  for (const auto& level : levels) {
    const auto here = found.find(level);
    if (here == found.end()) {
      without.push_back(level);
    } else if (here->second.size() < usual) {
      fewer.push_back(level + ' ' + std::to_string(here->second.size()));
    }
  }
  if (!without.empty()) {
    out.push_back(finding(Kind::kLevelWithoutStrokes, Severity::kWarning, first, "level",
                          first.participant + " has no strokes at " + base::joined(without, ", ") +
                              ": the terms of the speed are made of the other levels alone."));
  }
  if (!fewer.empty()) {
    out.push_back(finding(Kind::kStrokesMissing, Severity::kNote, first, "stroke",
                          first.participant + " has fewer strokes than the usual " + std::to_string(usual) + ": " +
                              base::joined(fewer, ", ") + '.'));
  }
  addSwapped(found, levels, out);
  return out;
}

}  // namespace tactus::experiments
