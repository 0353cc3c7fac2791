#include "tests/stress/band_population.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "core/base/check.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/force/force_terms_from.h"
#include "elicitation/rules/expert_rules.h"

#include "tests/support/default_procedure.h"
#include "tests/support/ngt_model.h"

namespace tactus::stress {
namespace {

using elicitation::Ramp;

constexpr int kSteps = 17;  // .1 to 1.7 N

int levelOf(const std::vector<fuzzy::Term>& terms, const std::string& id) {
  return static_cast<int>(std::find_if(terms.begin(), terms.end(), [&](const auto& one) { return one.id == id; }) -
                          terms.begin());
}

/// Thresholds around those of Table 2's split, with a scale of the nurse's own.
void addJudgements(const std::string& code, base::Random& random, study::Study& study) {
  const auto terms = support::ngtOutput().terms;
  const std::array<double, 4> middle_n = {.2, .325, .55, .775};
  const double scale = std::exp(.2 * random.normal());
  std::vector<double> thresholds_n;
  for (const double one : middle_n) thresholds_n.push_back(one * scale * std::exp(.12 * random.normal()));
  std::sort(thresholds_n.begin(), thresholds_n.end());
  for (int step = 1; step <= kSteps; ++step) {
    study::ForceJudgement one;
    one.participant = code;
    one.series = "ascending";
    one.step = step;
    one.force_n = step / 10.0;
    one.kind = step > 11 ? study::ForceJudgement::Kind::kBeyondPractice : study::ForceJudgement::Kind::kTerm;
    const auto level = std::upper_bound(thresholds_n.begin(), thresholds_n.end(), one.force_n) - thresholds_n.begin();
    if (step <= 11) one.term = terms[static_cast<std::size_t>(level)].id;
    study.judgements.push_back(one);
  }
}

/// Words around S4's: the nurse as a whole, each region and each cell differ.
void addRules(const std::string& code, base::Random& random, study::Study& study) {
  static const fuzzy::ForceModel kS4 = support::s4FiveRegions();
  const double whole = .3 * random.normal();
  std::map<std::string, double> of_region;
  for (const auto& rule : kS4.experts.front().rules) {
    const auto region = of_region.try_emplace(rule.conditions[1].term, 0);
    if (region.second) region.first->second = .4 * random.normal();
    study::GivenRule given;
    given.participant = code;
    for (const auto& condition : rule.conditions) given.conditions.push_back({condition.input, condition.term});
    const double level = levelOf(kS4.output.terms, rule.then) + whole + region.first->second + .5 * random.normal();
    given.then = kS4.output.terms[static_cast<std::size_t>(std::clamp(std::lround(level), 0L, 4L))].id;
    study.rules.push_back(given);
  }
}

std::vector<Ramp> ramps(base::Random& random) {
  const double scale = std::exp(.35 * random.normal());
  const double p1 = 45 * scale * std::exp(.1 * random.normal());
  const double q1 = p1 + 50 * scale * std::exp(.2 * random.normal());
  const double p2 = q1 + 25 * scale * std::exp(.2 * random.normal());
  return {{p1, q1}, {p2, p2 + 60 * scale * std::exp(.2 * random.normal())}};
}

/// Adds `people` nurses; returns their ramps.
std::vector<std::vector<Ramp>> addNurses(int people, base::Random& random, study::Study& study) {
  std::vector<std::vector<Ramp>> all;
  for (int i = 0; i < people; ++i) {
    study::Participant one;
    one.code = "N" + std::to_string(i + 1);
    one.simulated = true;
    study.participants.push_back(one);
    addJudgements(one.code, random, study);
    addRules(one.code, random, study);
    all.push_back(ramps(random));
  }
  return all;
}

void setSpeeds(fuzzy::ForceModel& model, const std::vector<Ramp>& averaged) {
  auto& speed = model.inputs[3];
  speed.max = 2000;  // wide enough for the fastest
  speed.terms = elicitation::speedTerms(speed, averaged);
}

}  // namespace

std::vector<std::vector<double>> bandPoints() {
  return {{1, 60, 70, 50}, {1, 60, 200, 50}, {1, 60, 300, 50}, {.3, 45, 170, 80}};
}

InventedStudy inventedStudy(int people, elicitation::ForceTermsFrom force_terms, base::Random& random) {
  InventedStudy out;
  out.settings.force_terms = force_terms;
  const auto all = addNurses(people, random, out.study);
  auto built = elicitation::buildModel(out.study, {}, out.settings);
  TACTUS_CHECK(built.has_value());
  out.built = std::move(*built);
  for (std::size_t i = 0; i < all.size(); ++i) {
    elicitation::ParticipantSpeeds speeds;
    speeds.participant = out.study.participants[i].code;
    speeds.ramps = all[i];
    out.built.speeds.push_back(std::move(speeds));
  }
  out.built.averaged_ramps = elicitation::averageRamps(all, {}, elicitation::Averaging::kMean);
  setSpeeds(out.built.model, out.built.averaged_ramps);
  return out;
}

std::vector<double> populationForces(elicitation::ForceTermsFrom force_terms) {
  constexpr int kStudies = 8;
  constexpr int kPeople = 1000;  // a model holds 1,024 experts
  std::vector<double> sums(bandPoints().size(), 0);
  base::Random random(99);
  for (int i = 0; i < kStudies; ++i) {
    study::Study study;
    const auto all = addNurses(kPeople, random, study);
    auto model = support::s4FiveRegions();
    model.experts.clear();
    for (const auto& one : study.participants) model.experts.push_back({one.code, one.code, 1, {}, {}});
    std::size_t expert = 0;
    for (const auto& rule : study.rules) {
      while (model.experts[expert].id != rule.participant) ++expert;
      model.experts[expert].rules.push_back(elicitation::ruleFrom(rule));
    }
    setSpeeds(model, elicitation::averageRamps(all, {}, elicitation::Averaging::kMean));
    std::vector<std::string> ids;
    for (const auto& term : model.output.terms) ids.push_back(term.id);
    const auto counts = elicitation::countVotes(study.judgements, "ascending", ids);
    TACTUS_CHECK(counts.has_value());
    const auto votes = elicitation::vote(*counts, kPeople);
    auto terms = elicitation::forceTermsFrom(force_terms, support::ngtOutput(), study.judgements, "ascending", votes,
                                             std::nullopt);
    TACTUS_CHECK(terms.has_value());
    model.output = terms->output;
    const auto compiled = fuzzy::compile(model);
    TACTUS_CHECK(compiled.has_value());
    for (std::size_t p = 0; p < sums.size(); ++p) sums[p] += compiled->evaluate(bandPoints()[p]).force_n / kStudies;
  }
  return sums;
}

}  // namespace tactus::stress
