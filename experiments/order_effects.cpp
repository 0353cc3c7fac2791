#include "experiments/order_effects.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/statistics.h"
#include "experiments/judgement_checks.h"

namespace tactus::experiments {
namespace {

MeanOverPersons meanOf(const std::vector<double>& values) {
  MeanOverPersons out;
  out.persons = values.size();
  if (values.empty()) return out;
  out.mean = base::mean(values);
  if (values.size() < 2) return out;
  out.standard_error = base::standardDeviation(values) / std::sqrt(static_cast<double>(values.size()));
  return out;
}

/// Whether two persons have different values of `key`, among those where it is not empty.
template <class Key>
bool differs(std::span<const DoneInOrder> done, const Key& key) {
  decltype(key(done.front())) first;
  for (const DoneInOrder& one : done) {
    auto now = key(one);
    if (now.empty()) continue;
    if (first.empty()) first = now;
    if (now != first) return true;
  }
  return false;
}

std::vector<MeanOverPersons> speedAtPlace(std::span<const DoneInOrder> done) {
  const auto order = [](const DoneInOrder& one) {
    std::vector<std::string> levels;
    for (const auto& [level, speed_mm_s] : one.speeds) levels.push_back(level);
    return levels;
  };
  if (!differs(done, order)) return {};
  std::map<std::string, std::vector<double>> of_level;
  for (const DoneInOrder& one : done) {
    for (const auto& [level, speed_mm_s] : one.speeds) of_level[level].push_back(speed_mm_s);
  }
  std::vector<std::vector<double>> at_place;
  for (const DoneInOrder& one : done) {
    at_place.resize(std::max(at_place.size(), one.speeds.size()));
    for (std::size_t place = 0; place < one.speeds.size(); ++place) {
      const auto& [level, speed_mm_s] = one.speeds[place];
      const double mean_mm_s = base::mean(of_level[level]);
      if (mean_mm_s > 0) at_place[place].push_back(speed_mm_s / mean_mm_s);
    }
  }
  std::vector<MeanOverPersons> out;
  for (const auto& values : at_place) out.push_back(meanOf(values));
  return out;
}

MeanOverPersons lateMinusEarly(std::span<const DoneInOrder> done) {
  const auto order = [](const DoneInOrder& one) {
    std::map<int, int> item_at;
    for (const auto& answer : one.answers) item_at[answer.position] = answer.item;
    return item_at;
  };
  if (!differs(done, order)) return {};
  std::map<int, std::vector<double>> of_item;
  for (const DoneInOrder& one : done) {
    for (const auto& answer : one.answers) of_item[answer.item].push_back(static_cast<double>(answer.term));
  }
  std::vector<double> differences;
  for (const DoneInOrder& one : done) {
    int last = 0;
    for (const auto& answer : one.answers) last = std::max(last, answer.position);
    std::vector<double> early;
    std::vector<double> late;
    for (const auto& answer : one.answers) {
      const double above = static_cast<double>(answer.term) - base::mean(of_item[answer.item]);
      if (3 * answer.position <= last) early.push_back(above);
      if (3 * answer.position > 2 * last) late.push_back(above);
    }
    if (!early.empty() && !late.empty()) differences.push_back(base::mean(late) - base::mean(early));
  }
  return meanOf(differences);
}

}  // namespace

OrderEffects orderEffects(std::span<const DoneInOrder> done, std::span<const std::string> terms) {
  OrderEffects out;
  std::vector<double> differences;
  for (const DoneInOrder& one : done) {
    const JudgementChecks checks = checkJudgements(one.judgements, terms);
    OrderEffects::Person person;
    person.participant = one.participant;
    person.simulated = one.simulated;
    person.blanks = checks.blanks.blanks;
    person.felt_blanks = checks.blanks.false_alarms;
    person.repeats = checks.repeats.hidden_pairs;
    person.same_repeats = static_cast<std::size_t>(
        std::lround(checks.repeats.hidden_same.value_or(0) * static_cast<double>(checks.repeats.hidden_pairs)));
    person.both_ways = checks.hysteresis.forces;
    person.up_minus_down = checks.hysteresis.index;
    if (person.up_minus_down) differences.push_back(*person.up_minus_down);
    if (person.blanks + person.repeats + person.both_ways > 0) out.persons.push_back(std::move(person));
  }
  out.up_minus_down = meanOf(differences);
  out.speed_at_place = speedAtPlace(done);
  out.late_minus_early = lateMinusEarly(done);
  return out;
}

}  // namespace tactus::experiments
