#include "elicitation/speed/level_diagnostics.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/term_conversion.h"
#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

constexpr double kLowSeparation = 1;    // below it two levels share most of their speeds
constexpr double kSignificance = 0.05;  // the usual level

std::string fixed1(double value) { return base::formatFixed(value, 1); }

void warnOfSeparation(LevelDiagnostics& out, const std::string& who) {
  for (std::size_t k = 0; k < out.separations.size(); ++k) {
    if (!out.separations[k] || *out.separations[k] >= kLowSeparation) continue;
    out.warnings.push_back(who + ": the levels " + out.levels[k].level + " and " + out.levels[k + 1].level +
                           " are hardly apart (d' " + base::formatFixed(*out.separations[k], 2) + ", below 1).");
  }
}

void warnOfCentres(LevelDiagnostics& out, std::span<const double> centres, const std::string& who) {
  for (std::size_t k = 0; k < centres.size() && k < out.levels.size(); ++k) {
    const LevelSpeeds& level = out.levels[k];
    if (level.samples == 0 || std::abs(centres[k] - level.mean_mm_s) <= level.sd_mm_s) continue;
    out.warnings.push_back(who + ": the center for " + level.level + ", " + fixed1(centres[k]) +
                           " mm/s, lies outside the mean ± SD of that level, " + fixed1(level.mean_mm_s) + " ± " +
                           fixed1(level.sd_mm_s) + " mm/s.");
  }
}

void warnOfTrend(LevelDiagnostics& out, const std::string& who) {
  if (!out.trend || out.trend->p <= kSignificance || out.trend->least_p > kSignificance) return;
  out.warnings.push_back(who + ": the means of the strokes do not clearly rise with the level (Jonckheere-Terpstra J " +
                         base::formatNumber(out.trend->j) + " of " + base::formatNumber(out.trend->most_j) + ", p " +
                         base::formatFixed(out.trend->p, 2) + ").");
}

}  // namespace

LevelDiagnostics levelDiagnostics(std::span<const study::SpeedSample> samples, std::span<const std::string> levels,
                                  std::span<const double> centres, const std::string& participant) {
  LevelDiagnostics out;
  out.levels = levelSpeeds(samples, levels);
  for (std::size_t k = 0; k + 1 < out.levels.size(); ++k) {
    out.separations.push_back(separation(out.levels[k], out.levels[k + 1]));
  }
  std::vector<std::vector<double>> strokes;
  for (const auto& level : out.levels) strokes.push_back(level.stroke_means_mm_s);
  out.trend = jonckheereTerpstra(strokes);
  out.confusion = levelConfusion(samples, levels, centres, participant);
  out.warnings = out.confusion.warnings;
  const std::string who = "Participant " + participant;
  warnOfSeparation(out, who);
  warnOfCentres(out, centres, who);
  warnOfTrend(out, who);
  return out;
}

std::size_t termAt(const fuzzy::Variable& speed, double speed_mm_s) {
  return analysis::strongestTerm(speed, std::clamp(speed_mm_s, speed.min, speed.max)).value_or(0);
}

std::optional<std::string> sameTermNote(std::span<const LevelSpeeds> levels, const fuzzy::Variable& averaged,
                                        const fuzzy::Variable& own, const std::string& participant) {
  std::vector<std::string> means;
  std::vector<std::string> own_terms;
  std::size_t term = 0;
  for (const auto& level : levels) {
    if (level.samples == 0) continue;
    const std::size_t reads = termAt(averaged, level.mean_mm_s);
    if (!means.empty() && reads != term) return std::nullopt;
    term = reads;
    means.push_back(level.level + " " + fixed1(level.mean_mm_s));
    own_terms.push_back(own.terms[termAt(own, level.mean_mm_s)].id);
  }
  if (means.size() < 2) return std::nullopt;
  return "Participant " + participant + ": with the averaged terms the mean speeds of all levels (" +
         base::joined(means, ", ") + " mm/s) read as " + averaged.terms[term].id +
         "; with terms of the participant's own (--terms own) they read as " + base::joined(own_terms, ", ") + ".";
}

}  // namespace tactus::elicitation
