#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "app/planning/nurse_family.h"
#include "app/planning/simulated_people.h"
#include "core/base/statistics.h"
#include "core/procedure/procedure.h"
#include "elicitation/force/force_thresholds.h"
#include "elicitation/force/force_voting.h"

namespace tactus::planning {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

using Rows = std::vector<std::vector<double>>;

constexpr std::size_t kAlike = 400;  // simulated nurses who differ by their noise alone
constexpr std::uint64_t kAlikeSeed = 1;
constexpr double kLeastThresholdN = 0.01;

double less(double sd, double noise_sd) { return std::sqrt(std::max(0.0, sd * sd - noise_sd * noise_sd)); }

/// The logarithms of each participant's thresholds in one series, by participant.
std::map<std::string, std::vector<double>> thresholdsOf(const Questions& questions,
                                                        const std::vector<study::ForceJudgement>& judgements,
                                                        const std::string& series) {
  std::map<std::string, std::vector<double>> out;
  const auto counts = elicitation::countVotes(judgements, series, questions.words());
  if (!counts) return out;
  const auto votes = elicitation::vote(*counts);
  const auto terms = elicitation::thresholdTerms(questions.about->output, judgements, series, votes);
  if (!terms) return out;
  for (const auto& one : terms->participants) {
    auto& row = out[one.participant];
    for (const double threshold : one.threshold_n) row.push_back(std::log(std::max(kLeastThresholdN, threshold)));
  }
  return out;
}

Rows rowsOf(const std::map<std::string, std::vector<double>>& by_participant) {
  Rows out;
  for (const auto& [participant, row] : by_participant) out.push_back(row);
  return out;
}

/// Nurses who are all like `family` describes on average, with their judgements and words.
std::vector<NurseData> alikeNurses(const Questions& questions, NurseFamily family, const RepeatNoise& noise) {
  family.threshold_log = family.threshold_own_log = 0;
  family.level_words = family.level_region_words = family.level_own_words = 0;
  family.speed_log = family.speed_own_log = 0;
  base::Random random(kAlikeSeed);
  std::vector<NurseData> out;
  for (std::size_t who = 0; who < kAlike; ++who) {
    auto data = dataOf(questions, family.draw(random), noise, 1, "N" + std::to_string(who + 1), random);
    if (data) out.push_back(std::move(*data));
  }
  return out;
}

SpreadParts thresholdSpread(const Questions& questions, const std::vector<NurseData>& people) {
  std::vector<study::ForceJudgement> all;
  for (const auto& one : people) all.insert(all.end(), one.judged.begin(), one.judged.end());
  const auto rows = rowsOf(thresholdsOf(questions, all, "ascending"));
  return rows.size() < 2 ? SpreadParts{} : spreadParts(rows);
}

/// The noise of judgements from those who judged several series; nothing if there are none.
std::optional<double> judgementNoise(const Questions& questions, const study::Study& study, const std::string& series,
                                     const SpreadParts& by_one_jnd) {
  const auto first = thresholdsOf(questions, study.judgements, series);
  std::vector<std::string> others;
  for (const auto& one : study.judgements) {
    if (one.series != series && std::find(others.begin(), others.end(), one.series) == others.end())
      others.push_back(one.series);
  }
  double square = 0;
  double count = 0;
  for (const auto& other : others) {
    const auto again = thresholdsOf(questions, study.judgements, other);
    Rows differences;
    for (const auto& [participant, row] : first) {
      const auto second = again.find(participant);
      if (second == again.end()) continue;
      auto& difference = differences.emplace_back();
      for (std::size_t i = 0; i < row.size(); ++i) difference.push_back(row[i] - second->second[i]);
    }
    if (differences.size() < 2) continue;
    // Less the mean difference of each threshold: what all do differently in the other series is no noise.
    const auto spread = spreadParts(differences);
    square += (spread.row * spread.row + spread.cell * spread.cell) / 2;
    ++count;
  }
  const double of_one = std::hypot(by_one_jnd.row, by_one_jnd.cell);
  if (count == 0 || !(of_one > 0)) return std::nullopt;
  return std::sqrt(square / count) / of_one;
}

/// Whether `inputs` have all terms of the conditions.
bool isKnown(const std::vector<fuzzy::Condition>& conditions, const std::vector<fuzzy::Variable>& inputs) {
  return std::all_of(conditions.begin(), conditions.end(), [&](const auto& one) {
    return std::any_of(inputs.begin(), inputs.end(), [&](const auto& input) {
      return input.id == one.input && fuzzy::findTerm(input.terms, one.term) != nullptr;
    });
  });
}

/// The questions of the study: the conditions of all rules, in the order of their first use. Those in a region that the
/// depth terms of most experts lack are left out, with a note.
void takeItems(const fuzzy::ForceModel& model, StudyFamily& out) {
  auto& items = out.questions.items;
  bool all_known = true;
  for (const auto& expert : model.experts) {
    for (const auto& rule : expert.rules) {
      const bool known = isKnown(rule.conditions, out.questions.inputs);
      all_known = all_known && known;
      if (known && std::find(items.begin(), items.end(), rule.conditions) == items.end())
        items.push_back(rule.conditions);
    }
  }
  if (!all_known) out.notes.push_back("Rules in a region that the form of most nurses does not have are left out.");
}

/// The words of each expert by question; a missing one is the mean of those that are there.
Rows levelsOf(const fuzzy::ForceModel& model, const Questions& questions) {
  const auto& items = questions.items;
  const auto ids = questions.words();
  std::vector<std::vector<std::optional<double>>> said;
  for (const auto& expert : model.experts) {
    auto& row = said.emplace_back(items.size());
    for (const auto& rule : expert.rules) {
      const auto item = std::find(items.begin(), items.end(), rule.conditions);
      if (item == items.end()) continue;
      row[static_cast<std::size_t>(item - items.begin())] =
          static_cast<double>(std::find(ids.begin(), ids.end(), rule.then) - ids.begin());
    }
  }
  Rows out(said.size(), std::vector<double>(items.size()));
  for (std::size_t item = 0; item < items.size(); ++item) {
    double sum = 0;
    double count = 0;
    for (const auto& row : said) {
      sum += row[item].value_or(0);
      count += row[item] ? 1 : 0;
    }
    for (std::size_t who = 0; who < said.size(); ++who) out[who][item] = said[who][item].value_or(sum / count);
  }
  return out;
}

void takeThresholds(const study::Study& study, const elicitation::BuildSettings& settings, StudyFamily& out) {
  const auto rows = rowsOf(thresholdsOf(out.questions, study.judgements, settings.series));
  if (rows.size() < 2) {
    out.notes.push_back("The thresholds between the force words are assumed: fewer than two nurses judged forces.");
    return;
  }
  const auto all = spreadParts(rows);
  auto& family = out.family;
  for (std::size_t i = 0; i < all.column_mean.size(); ++i) family.threshold_n[i] = std::exp(all.column_mean[i]);
  family.beyond_from_n = std::max(family.beyond_from_n, family.threshold_n.back());
  const auto by_one_jnd = thresholdSpread(out.questions, alikeNurses(out.questions, family, out.noise));
  if (const auto noise = judgementNoise(out.questions, study, settings.series, by_one_jnd)) {
    out.noise.judgement_jnd = *noise;
  } else {
    out.notes.push_back(
        "The noise of the judgements is assumed, one just-noticeable difference: no two nurses judged "
        "more than one series.");
  }
  const auto alike = thresholdSpread(out.questions, alikeNurses(out.questions, family, out.noise));
  family.threshold_log = less(all.row, alike.row);
  family.threshold_own_log = less(all.cell, alike.cell);
}

void takeLevels(const elicitation::BuiltModel& built, StudyFamily& out) {
  auto& family = out.family;
  family.region = regionsOf(out.questions);
  const auto all = spreadParts(levelsOf(built.model, out.questions), family.region);
  family.level = all.column_mean;
  Rows rows;
  for (const auto& one : alikeNurses(out.questions, family, out.noise))
    rows.emplace_back(one.words.begin(), one.words.end());
  const auto alike = spreadParts(rows, family.region);
  family.level_words = less(all.row, alike.row);
  family.level_region_words = less(all.group, alike.group);
  family.level_own_words = less(all.cell, alike.cell);
  out.notes.push_back("The noise of the answers is assumed, 0.4 words: the study asks each question once.");
}

void takeSpeeds(const elicitation::BuiltModel& built, StudyFamily& out) {
  if (out.questions.speeds() == 0) return;
  Rows rows;
  for (const auto& one : built.speeds) {
    std::vector<double> row;
    for (const auto& level : one.diagnostics.levels) {
      if (level.mean_mm_s > 0) row.push_back(std::log(level.mean_mm_s));
      out.strokes = std::max(out.strokes, level.stroke_means_mm_s.size());
    }
    if (row.size() == out.family.speed_mm_s.size()) rows.push_back(std::move(row));
  }
  if (rows.size() < 2) {
    out.notes.push_back("The speeds are assumed: fewer than two nurses moved at every speed.");
    return;
  }
  const auto all = spreadParts(rows);
  for (std::size_t i = 0; i < all.column_mean.size(); ++i) out.family.speed_mm_s[i] = std::exp(all.column_mean[i]);
  out.family.speed_log = all.row;
  out.family.speed_own_log =
      less(all.cell, out.noise.stroke_log / std::sqrt(static_cast<double>(std::max<std::size_t>(1, out.strokes))));
}

}  // namespace

Result<StudyFamily> familyOf(const study::Study& study, const elicitation::BuiltModel& built,
                             const elicitation::BuildSettings& settings) {
  StudyFamily out;
  out.nurses = built.model.experts.size();
  if (out.nurses < 2)
    return fail(ErrorCode::kData, "study", std::to_string(out.nurses) + " nurse with rules",
                "at least two, to see how they differ");
  out.questions = questionsOf(study.procedure != nullptr ? study.procedure : procedure::defaultProcedure());
  out.family = defaultFamily(out.questions);
  out.questions.items.clear();
  const std::size_t way = out.questions.about->way();
  out.questions.inputs[way] = built.model.inputs[way];
  takeItems(built.model, out);
  if (out.questions.items.empty())
    return fail(ErrorCode::kData, "study", "no rules about regions that most nurses were asked about", "some");
  // The alike nurses of the thresholds answer nothing yet.
  out.family.level.clear();
  out.family.region.clear();
  takeThresholds(study, settings, out);
  takeLevels(built, out);
  takeSpeeds(built, out);
  return out;
}

}  // namespace tactus::planning
