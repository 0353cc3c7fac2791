#include "app/planning/nurse_family.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/session/simulated_nurse.h"
#include "app/session/simulated_study.h"
#include "core/base/check.h"
#include "core/base/statistics.h"
#include "core/procedure/procedure.h"
#include "experiments/published_tables.h"

namespace tactus::planning {
namespace {

double variance(const std::vector<double>& sample) { return std::pow(base::standardDeviation(sample), 2); }

std::vector<double> exponentials(std::vector<double> logs) {
  for (double& one : logs) one = std::exp(one);
  return logs;
}

bool isOfPaper(const Questions& questions) { return questions.about == procedure::defaultProcedure(); }

/// The mean word of the simulated persons at each question that leads to a rule, over several seeds.
std::vector<double> typicalLevels(const Questions& questions) {
  constexpr std::uint64_t kSeeds = 10;
  const study::Form& form = questions.about->forms.front();
  std::vector<double> sum(form.items.size(), 0);
  std::vector<double> count(form.items.size(), 0);
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto answers = isOfPaper(questions) ? session::simulatedAnswers(form, seed)
                                              : session::simulatedExpert(*questions.about, form, seed, 0).answers;
    for (const auto& answer : answers) {
      const auto item = std::find_if(form.items.begin(), form.items.end(),
                                     [&](const auto& one) { return one.number == answer.item; });
      const auto word = std::find_if(form.answers.begin(), form.answers.end(),
                                     [&](const auto& one) { return one.term == answer.term; });
      const auto place = static_cast<std::size_t>(item - form.items.begin());
      sum[place] += static_cast<double>(word - form.answers.begin());
      ++count[place];
    }
  }
  std::vector<double> out;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    if (!study::isWayOut(form.items[i])) out.push_back(sum[i] / count[i]);
  }
  return out;
}

}  // namespace

std::vector<std::string> Questions::words() const {
  std::vector<std::string> out;
  for (const auto& term : about->output.terms) out.push_back(term.id);
  return out;
}

std::size_t Questions::speeds() const {
  const auto* const rate = about->rateInput();
  return rate == nullptr ? 0 : rate->terms.size();
}

Questions questionsOf(const session::ProcedurePtr& about) {
  const study::Form& form = about->forms.front();
  Questions out;
  out.about = about;
  out.inputs = about->inputs;
  out.inputs[about->way()].terms = about->wayTerms(form.depth_terms)->terms;
  for (const auto& item : form.items) {
    if (study::isWayOut(item)) continue;  // leads to no rule
    auto& conditions = out.items.emplace_back();
    for (const auto& one : item.conditions) conditions.push_back({one.input, one.term});
  }
  const auto protocol = session::firstProtocol(about);
  TACTUS_CHECK(protocol.has_value());  // a pack without one is refused when it is read
  const auto& ladder = protocol->settings.force.ladder;
  for (int i = 0; i < ladder.count(); ++i) out.forces_n.push_back(ladder.at(i));
  return out;
}

std::vector<std::size_t> regionsOf(const Questions& questions) {
  std::map<std::string, std::size_t> seen;
  std::vector<std::size_t> out;
  const std::string& depth = questions.inputs[fuzzy::wayOf(questions.inputs).value()].id;
  for (const auto& item : questions.items) {
    std::string region;
    for (const auto& condition : item) {
      if (condition.input == depth) region = condition.term;
    }
    out.push_back(seen.try_emplace(region, seen.size()).first->second);
  }
  return out;
}

SpreadParts spreadParts(const std::vector<std::vector<double>>& rows, std::vector<std::size_t> group) {
  TACTUS_CHECK(rows.size() >= 2 && !rows.front().empty());
  for (std::size_t c = group.size(); c < rows.front().size(); ++c) group.push_back(c);
  const std::size_t columns = group.size();
  const std::size_t groups = *std::max_element(group.begin(), group.end()) + 1;
  const auto n = static_cast<double>(rows.size());
  SpreadParts out;
  out.column_mean.assign(columns, 0);
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < columns; ++c) out.column_mean[c] += row[c] / n;
  }
  std::vector<double> size(groups, 0);
  for (const std::size_t one : group) ++size[one];
  // Each row less the column means: its mean, the means of its groups, the rest.
  std::vector<double> row_mean;
  std::vector<std::vector<double>> group_mean(groups);
  double rest = 0;
  for (const auto& row : rows) {
    std::vector<double> sums(groups, 0);
    double all = 0;
    for (std::size_t c = 0; c < columns; ++c) {
      sums[group[c]] += row[c] - out.column_mean[c];
      all += row[c] - out.column_mean[c];
    }
    row_mean.push_back(all / static_cast<double>(columns));
    for (std::size_t g = 0; g < groups; ++g) group_mean[g].push_back(sums[g] / size[g]);
    for (std::size_t c = 0; c < columns; ++c) {
      rest += std::pow(row[c] - out.column_mean[c] - group_mean[group[c]].back(), 2);
    }
  }
  const double mean_size = static_cast<double>(columns) / static_cast<double>(groups);
  const auto count = static_cast<double>(groups);
  double of_groups = 0;  // variance of a group's mean within its row
  if (groups > 1) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      double mean = 0;
      for (std::size_t g = 0; g < groups; ++g) mean += group_mean[g][r] / count;
      for (std::size_t g = 0; g < groups; ++g) of_groups += std::pow(group_mean[g][r] - mean, 2);
    }
    of_groups /= (n - 1) * (count - 1);
  }
  const bool single = groups == columns;
  const double cell = single ? of_groups : rest / ((n - 1) * (static_cast<double>(columns) - count));
  const double between = single ? 0 : std::max(0.0, of_groups - cell / mean_size);
  out.cell = std::sqrt(cell);
  out.group = std::sqrt(between);
  out.row = std::sqrt(std::max(0.0, variance(row_mean) - of_groups / count));
  return out;
}

TrueNurse NurseFamily::draw(base::Random& random) const {
  TrueNurse out;
  const double all = threshold_log * random.normal();
  for (const double one : threshold_n)
    out.threshold_n.push_back(one * std::exp(all + threshold_own_log * random.normal()));
  std::sort(out.threshold_n.begin(), out.threshold_n.end());
  out.beyond_from_n = std::max(beyond_from_n * std::exp(all), out.threshold_n.back());
  const double whole = level_words * random.normal();
  std::vector<double> of_region(region.empty() ? 0 : *std::max_element(region.begin(), region.end()) + 1);
  for (double& one : of_region) one = level_region_words * random.normal();
  for (std::size_t i = 0; i < level.size(); ++i)
    out.level.push_back(level[i] + whole + of_region[region[i]] + level_own_words * random.normal());
  const double hand = speed_log * random.normal();
  for (const double one : speed_mm_s) out.speed_mm_s.push_back(one * std::exp(hand + speed_own_log * random.normal()));
  std::sort(out.speed_mm_s.begin(), out.speed_mm_s.end());
  return out;
}

NurseSource sourceOf(NurseFamily family) {
  return [family = std::move(family)](base::Random& random) { return family.draw(random); };
}

NurseFamily defaultFamily(const Questions& questions) {
  NurseFamily out;
  std::vector<std::vector<double>> thresholds;
  for (const auto& one : session::respondersOfTable2()) {
    auto& row = thresholds.emplace_back();
    for (const double threshold : one.threshold_n) row.push_back(std::log(threshold));
    out.beyond_from_n = one.beyond_from_n;
  }
  const auto felt = spreadParts(thresholds);
  out.threshold_n = exponentials(felt.column_mean);
  out.threshold_log = felt.row;
  out.threshold_own_log = felt.cell;
  std::map<std::string, std::vector<double>> speeds;
  for (const auto& one : experiments::publishedSpeeds()) speeds[one.participant].push_back(std::log(one.mean_mm_s));
  std::vector<std::vector<double>> rows;
  for (const auto& [participant, row] : speeds) rows.push_back(row);
  const auto moved = spreadParts(rows);
  out.speed_mm_s = exponentials(moved.column_mean);
  out.speed_log = moved.row;
  out.speed_own_log = moved.cell;
  out.level = typicalLevels(questions);
  TACTUS_CHECK(out.level.size() == questions.items.size());
  out.region = regionsOf(questions);
  const double words = static_cast<double>(questions.words().size()) / 5;
  out.level_words = 0.5 * words;
  out.level_region_words = 0.4 * words;
  out.level_own_words = 0.45 * words;
  if (isOfPaper(questions)) return out;
  const auto& about = *questions.about;
  const auto typical = session::simulatedExpert(about, about.forms.front(), 1, 0).responder;
  out.threshold_n = typical.threshold_n;
  out.beyond_from_n = typical.beyond_from_n;
  out.speed_mm_s = session::typicalSpeeds(about);
  return out;
}

}  // namespace tactus::planning
