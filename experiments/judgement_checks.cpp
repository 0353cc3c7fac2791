#include "experiments/judgement_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/statistics.h"
#include "core/base/text.h"
#include "experiments/force_series.h"

namespace tactus::experiments {

std::optional<double> quadraticWeightedKappa(std::span<const std::pair<std::size_t, std::size_t>> pairs) {
  const auto squared = [](std::size_t a, std::size_t b) {
    const double difference = static_cast<double>(a) - static_cast<double>(b);
    return difference * difference;
  };
  double observed = 0;
  double by_chance = 0;
  for (const auto& pair : pairs) {
    observed += squared(pair.first, pair.second);
    for (const auto& other : pairs) by_chance += squared(pair.first, other.second);
  }
  if (by_chance == 0) return std::nullopt;
  return 1 - observed * static_cast<double>(pairs.size()) / by_chance;
}

namespace {

using Answer = study::ForceJudgement::Kind;

constexpr double kSameStepN = 1e-9;
constexpr std::size_t kFewestForOutliers = 8;
constexpr double kTukey = 1.5;

// From here on a check is marked as notable. Our own marks, for the eye only.
constexpr double kNotableViolations = 0.1;  // of the pairs
constexpr double kNotableHysteresis = 0.5;  // terms
constexpr double kNotableKappa = 0.6;       // "substantial" ends here (Landis and Koch 1977)

/// A scored judgement with a term.
struct Judged {
  const study::JudgementRecord* record;
  std::size_t term;
};

bool sameForce(const Judged& a, const Judged& b) {
  return std::abs(a.record->commanded_n - b.record->commanded_n) < kSameStepN;
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

std::string percent(double share) { return base::formatFixed(100 * share, 0) + " %"; }

class Checker {
 public:
  Checker(std::span<const study::JudgementRecord> records, std::span<const std::string> terms)
      : records_(records), terms_(terms) {
    std::set<study::RecordId> corrected;
    for (const auto& record : records) {
      if (record.entry.supersedes) corrected.insert(*record.entry.supersedes);
    }
    for (std::size_t i = 0; i < records.size(); ++i) {
      if (corrected.contains(records[i].entry.id)) continue;
      live_.push_back(i);
      const auto term = std::find(terms.begin(), terms.end(), records[i].term);
      if (records[i].scored && records[i].kind == Answer::kTerm && term != terms.end()) {
        judged_.push_back({&records[i], static_cast<std::size_t>(term - terms.begin())});
      }
    }
  }

  JudgementChecks check() {
    checkMonotonicity();
    checkHysteresis();
    checkRepeats();
    checkBlanks();
    checkResponseTimes();
    checkMotion();
    findThresholds();
    return std::move(result_);
  }

 private:
  void say(std::string check, bool notable, std::string sentence) {
    result_.findings.push_back({std::move(check), notable, std::move(sentence)});
  }

  std::vector<Judged> ofSeries(std::string_view series) const {
    std::vector<Judged> out;
    for (const auto& judged : judged_) {
      if (judged.record->series == series && judged.record->commanded_n > 0) out.push_back(judged);
    }
    return out;
  }

  void checkMonotonicity() {
    std::vector<std::string> names;
    for (const auto& judged : judged_) {
      const auto& series = judged.record->series;
      if (std::find(names.begin(), names.end(), series) == names.end()) names.push_back(series);
    }
    for (const auto& series : names) {
      MonotonicityCheck check{series, 0, 0};
      const auto judged = ofSeries(series);
      for (std::size_t i = 0; i < judged.size(); ++i) {
        for (std::size_t k = i + 1; k < judged.size(); ++k) {
          if (sameForce(judged[i], judged[k])) continue;
          ++check.pairs;
          const bool rises = judged[i].record->commanded_n < judged[k].record->commanded_n;
          const Judged& weak = rises ? judged[i] : judged[k];
          const Judged& strong = rises ? judged[k] : judged[i];
          if (strong.term < weak.term) ++check.violations;
        }
      }
      const double share =
          check.pairs == 0 ? 0 : static_cast<double>(check.violations) / static_cast<double>(check.pairs);
      say("monotonicity", share > kNotableViolations,
          "In the " + series + " series the term falls though the force rises in " + std::to_string(check.violations) +
              " of " + counted(check.pairs, "pair of forces.", "pairs of forces."));
      result_.monotonicity.push_back(std::move(check));
    }
  }

  void checkHysteresis() {
    auto& check = result_.hysteresis;
    double difference = 0;
    for (const auto& up : ofSeries(kAscending)) {
      for (const auto& down : ofSeries(kDescending)) {
        if (!sameForce(up, down) || up.record->catch_trial || down.record->catch_trial) continue;
        ++check.forces;
        difference += static_cast<double>(up.term) - static_cast<double>(down.term);
      }
    }
    if (check.forces == 0) return;
    check.index = difference / static_cast<double>(check.forces);
    say("hysteresis", std::abs(*check.index) > kNotableHysteresis,
        "On the way up forces were called " + base::formatFixed(std::abs(*check.index), 2) + " terms " +
            (*check.index < 0 ? "lower" : "higher") + " than on the way down, as the mean of " +
            counted(check.forces, "force.", "forces."));
  }

  void checkRepeats() {
    auto& check = result_.repeats;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    std::size_t close = 0;
    std::size_t hidden_same = 0;
    for (const char* series : {kAscending, kDescending, kRandom}) {
      const auto judged = ofSeries(series);
      for (std::size_t later = 0; later < judged.size(); ++later) {
        for (std::size_t earlier = 0; earlier < later; ++earlier) {
          if (!sameForce(judged[earlier], judged[later])) continue;
          const auto [a, b] = pairs.emplace_back(judged[earlier].term, judged[later].term);
          if (std::max(a, b) - std::min(a, b) <= 1) ++close;
          if (!judged[later].record->catch_trial) continue;
          ++check.hidden_pairs;
          if (a == b) ++hidden_same;
        }
      }
    }
    check.pairs = pairs.size();
    if (pairs.empty()) return;
    check.kappa = quadraticWeightedKappa(pairs);
    check.within_one = static_cast<double>(close) / static_cast<double>(pairs.size());
    if (check.hidden_pairs > 0) {
      check.hidden_same = static_cast<double>(hidden_same) / static_cast<double>(check.hidden_pairs);
    }
    const std::string kappa =
        check.kappa ? base::formatFixed(*check.kappa, 2) : "not defined: all answers are one term";
    say("repeats", check.kappa.value_or(1) < kNotableKappa,
        "When a force came again, " + percent(*check.within_one) + " of " +
            counted(check.pairs, "pair of answers was", "pairs of answers were") +
            " at most one term apart (quadratic-weighted kappa " + kappa + ").");
  }

  void checkBlanks() {
    auto& check = result_.blanks;
    for (const std::size_t i : live_) {
      const auto& record = records_[i];
      if (!record.scored || record.commanded_n != 0 || record.kind == Answer::kNoAnswer) continue;
      ++check.blanks;
      if (record.kind != Answer::kNotFelt) ++check.false_alarms;
    }
    if (check.blanks == 0) return;
    say("blanks", 2 * check.false_alarms > check.blanks,
        "A force was felt in " + std::to_string(check.false_alarms) + " of " +
            counted(check.blanks, "step without one", "steps without one") +
            "; the device's own friction can be felt there.");
  }

  void checkResponseTimes() {
    auto& check = result_.response_time;
    std::vector<double> times_s;
    std::vector<std::size_t> indices;
    for (const std::size_t i : live_) {
      if (!records_[i].scored || records_[i].response_s <= 0) continue;
      times_s.push_back(records_[i].response_s);
      indices.push_back(i);
    }
    check.judgements = times_s.size();
    if (times_s.empty()) return;
    check.median_s = base::median(times_s);
    if (times_s.size() >= kFewestForOutliers) {
      std::vector<double> logs;
      logs.reserve(times_s.size());
      for (const double time_s : times_s) logs.push_back(std::log(time_s));
      const double lower = base::quantile(logs, 0.25);
      const double upper = base::quantile(logs, 0.75);
      const double margin = kTukey * (upper - lower);
      for (std::size_t k = 0; k < logs.size(); ++k) {
        if (logs[k] < lower - margin || logs[k] > upper + margin) check.outliers.push_back(indices[k]);
      }
    }
    say("response_time", !check.outliers.empty(),
        "The median response took " + base::formatFixed(*check.median_s, 1) + " s; " +
            counted(check.outliers.size(), "response was", "responses were") + " unusually short or long.");
  }

  /// Steps without a scored attempt, except the one at which the records end.
  std::size_t countLeftOut() const {
    std::set<std::pair<std::string, int>> asked;
    std::set<std::pair<std::string, int>> scored;
    std::pair<std::string, int> last;
    for (const std::size_t i : live_) {
      if (records_[i].series == kFamiliarisation) continue;
      last = {records_[i].series, records_[i].step};
      asked.insert(last);
      if (records_[i].scored) scored.insert(last);
    }
    asked.erase(last);
    return static_cast<std::size_t>(
        std::count_if(asked.begin(), asked.end(), [&](const auto& step) { return !scored.contains(step); }));
  }

  void checkMotion() {
    auto& check = result_.motion;
    check.left_out = countLeftOut();
    std::vector<double> speeds_mm_s;
    for (const std::size_t i : live_) {
      const auto& record = records_[i];
      if (record.scored) {
        speeds_mm_s.push_back(record.forward_speed_mm_s);
      } else if (record.series != kFamiliarisation) {
        ++check.repeated;
      }
    }
    check.judgements = speeds_mm_s.size();
    if (speeds_mm_s.empty()) return;
    check.median_mm_s = base::median(speeds_mm_s);
    check.slowest_mm_s = *std::min_element(speeds_mm_s.begin(), speeds_mm_s.end());
    check.fastest_mm_s = *std::max_element(speeds_mm_s.begin(), speeds_mm_s.end());
    const std::string left_out = counted(check.left_out, "step was", "steps were") + " left out for that.";
    say("motion", check.repeated > check.judgements || check.left_out > 0,
        "Forces were judged at " + base::formatFixed(*check.median_mm_s, 0) + " mm/s forward (median; " +
            base::formatFixed(*check.slowest_mm_s, 0) + " to " + base::formatFixed(*check.fastest_mm_s, 0) + "); " +
            counted(check.repeated, "attempt", "attempts") +
            " did not count: without forward motion, or without the whole force" +
            (check.left_out > 0 ? "; " + left_out : std::string(".")));
  }

  void findThresholds() {
    std::vector<study::TermAtForce> points;
    for (const auto& judged : judged_) {
      if (judged.record->commanded_n > 0) points.push_back({judged.record->commanded_n, judged.term});
    }
    result_.thresholds = study::termThresholds(points, terms_.size());
    if (points.empty()) return;
    std::vector<std::string> places;
    for (const auto& threshold_n : result_.thresholds.threshold_n) {
      places.push_back(threshold_n ? base::formatFixed(*threshold_n, 2) : "?");
    }
    const bool probit = result_.thresholds.method == study::TermThresholds::Method::kOrderedProbit;
    say("thresholds", false,
        "The terms change at " + base::joined(places, ", ") + " N (" +
            (probit ? "ordered probit, spread " + base::formatFixed(*result_.thresholds.sigma_n, 2) + " N"
                    : std::string("midpoints between neighboring forces")) +
            ").");
  }

  std::span<const study::JudgementRecord> records_;
  std::span<const std::string> terms_;
  std::vector<std::size_t> live_;
  std::vector<Judged> judged_;
  JudgementChecks result_;
};

}  // namespace

JudgementChecks checkJudgements(std::span<const study::JudgementRecord> records, std::span<const std::string> terms) {
  return Checker(records, terms).check();
}

}  // namespace tactus::experiments
