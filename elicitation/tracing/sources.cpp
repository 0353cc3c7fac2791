#include "elicitation/tracing/sources.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/analysis/explain.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::elicitation {
namespace {

std::optional<std::size_t> expertOf(const BuiltModel& built, const std::string& participant,
                                    ExpertRules::Source source) {
  const auto found = std::find_if(built.experts.begin(), built.experts.end(), [&](const ExpertRules& one) {
    return one.participant.code == participant && one.source == source;
  });
  if (found == built.experts.end()) return std::nullopt;
  return static_cast<std::size_t>(found - built.experts.begin());
}

}  // namespace

std::optional<RulePlace> ruleOfAnswer(const study::Study& study, const BuiltModel& built, std::size_t index) {
  const study::Answer& answer = study.answers[index];
  const auto expert = expertOf(built, answer.participant, ExpertRules::Source::kAnswers);
  if (!expert) return std::nullopt;
  const auto& origins = built.experts[*expert].origins;
  const auto found = std::find_if(origins.begin(), origins.end(), [&](const RuleOrigin& one) {
    return one.form == answer.form && one.item == answer.item;
  });
  if (found == origins.end()) return std::nullopt;
  return RulePlace{*expert, static_cast<std::size_t>(found - origins.begin())};
}

std::optional<RulePlace> ruleOfGiven(const study::Study& study, const BuiltModel& built, std::size_t index) {
  const std::string& participant = study.rules[index].participant;
  const auto expert = expertOf(built, participant, ExpertRules::Source::kGiven);
  if (!expert) return std::nullopt;
  // The rules of a participant keep the order of the table.
  const auto before = std::count_if(study.rules.begin(), study.rules.begin() + static_cast<std::ptrdiff_t>(index),
                                    [&](const study::GivenRule& one) { return one.participant == participant; });
  return RulePlace{*expert, static_cast<std::size_t>(before)};
}

namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr std::size_t kCorners = 4;  // of the trapezoids that speeds and votes give

/// `more` behind `into`, without what is there already.
template <class List>
void join(List& into, const List& more) {
  for (const auto& one : more) {
    if (std::find(into.begin(), into.end(), one) == into.end()) into.push_back(one);
  }
}

void add(Sources& into, const Sources& more) {
  join(into.strokes, more.strokes);
  join(into.judgements, more.judgements);
  join(into.answers, more.answers);
  join(into.rules, more.rules);
  join(into.without_records, more.without_records);
}

void sort(Sources& sources) {
  std::sort(sources.judgements.begin(), sources.judgements.end());
  std::sort(sources.answers.begin(), sources.answers.end());
  std::sort(sources.rules.begin(), sources.rules.end());
}

std::vector<StrokeKey> strokesOf(const study::Study& study, const std::string& participant) {
  std::vector<StrokeKey> out;
  for (const auto& sample : study.speeds) {
    if (sample.participant != participant) continue;
    StrokeKey key{sample.participant, sample.level, sample.stroke};
    if (!out.empty() && out.back() == key) continue;
    if (std::find(out.begin(), out.end(), key) == out.end()) out.push_back(std::move(key));
  }
  return out;
}

Result<std::size_t> termIndex(const fuzzy::Variable& variable, std::string_view term, std::size_t point) {
  const auto found =
      std::find_if(variable.terms.begin(), variable.terms.end(), [term](const auto& one) { return one.id == term; });
  if (found == variable.terms.end()) {
    std::vector<std::string> ids;
    for (const auto& one : variable.terms) ids.push_back(one.id);
    return fail(ErrorCode::kReference, variable.id, "term " + base::quoted(term), "one of " + base::joined(ids, ", "));
  }
  if (point >= found->points.size()) {
    return fail(ErrorCode::kReference, variable.id + " " + std::string(term), "vertex " + std::to_string(point),
                "a vertex from 0 to " + std::to_string(found->points.size() - 1));
  }
  return static_cast<std::size_t>(found - variable.terms.begin());
}

/// The ramp whose end a vertex is: gap and end; nothing for a vertex at an end of the universe.
struct RampEnd {
  std::size_t gap = 0;
  bool lower = false;  ///< its p, else its q
};
std::optional<RampEnd> rampEnd(std::size_t term, std::size_t point, std::size_t terms) {
  if (point < 2) {
    if (term == 0) return std::nullopt;
    return RampEnd{term - 1, point == 0};
  }
  if (term + 1 == terms) return std::nullopt;
  return RampEnd{term, point == 2};
}

const fuzzy::Variable& speedIn(const fuzzy::ForceModel& model) {
  return model.inputs[fuzzy::rateOf(model.inputs).value()];
}

Sources allJudgements(const study::Study& study, const BuildSettings& settings) {
  Sources out;
  for (std::size_t i = 0; i < study.judgements.size(); ++i) {
    if (study.judgements[i].series == settings.series) out.judgements.push_back(i);
  }
  return out;
}

/// The judgements behind a vertex of the force: where a core begins or ends at a step, those of that step; where a
/// vertex lies between steps, those of the step before and after it.
Sources votesBehind(const study::Study& study, const BuiltModel& built, const BuildSettings& settings, double value_n) {
  Sources out;
  double before_n = -1;
  double after_n = -1;
  for (const auto& step : built.votes) {
    if (step.force_n <= value_n + kSameForceN) before_n = step.force_n;
    if (step.force_n >= value_n - kSameForceN && after_n < 0) after_n = step.force_n;
  }
  for (const double force_n : {before_n, after_n}) {
    if (force_n >= 0) add(out, sourcesOfVote(study, settings, force_n));
  }
  return out;
}

Sources without(std::string sentence) {
  Sources out;
  out.without_records.push_back(std::move(sentence));
  return out;
}

/// The vertices of `terms` that decide the membership at `value`: of the slope on which it lies.
std::vector<std::pair<std::size_t, std::size_t>> slopesAt(const std::vector<fuzzy::Term>& terms, double value) {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (terms[t].points.size() != kCorners) continue;
    const auto& p = terms[t].points;
    if (value > p[0] && value < p[1]) out.insert(out.end(), {{t, 0}, {t, 1}});
    if (value > p[2] && value < p[3]) out.insert(out.end(), {{t, 2}, {t, 3}});
  }
  return out;
}

}  // namespace

Result<std::vector<VertexShare>> speedVertexShares(const study::Study& study, const BuiltModel& built,
                                                   const BuildSettings& settings, std::string_view term,
                                                   std::size_t point) {
  const auto& speed = speedIn(built.model);
  TACTUS_TRY(const auto index, termIndex(speed, term, point));
  std::vector<VertexShare> out;
  const auto end = rampEnd(index, point, speed.terms.size());
  if (!end || built.speeds.empty()) return out;
  double weights = 0;
  for (std::size_t i = 0; i < built.speeds.size(); ++i) {
    const auto& one = built.speeds[i];
    const double weight = built.speed_weights.empty() ? 1 : built.speed_weights[i];
    weights += weight;
    const auto& ramp = one.ramps[end->gap];
    out.push_back({one.participant, end->lower ? ramp.p : ramp.q, weight, strokesOf(study, one.participant)});
  }
  for (auto& one : out)
    one.share = settings.averaging == Averaging::kMedian || !(weights > 0) ? 0 : one.share / weights;
  return out;
}

Sources sourcesOfVote(const study::Study& study, const BuildSettings& settings, double force_n) {
  Sources out;
  for (std::size_t i = 0; i < study.judgements.size(); ++i) {
    const auto& one = study.judgements[i];
    if (one.series == settings.series && std::abs(one.force_n - force_n) < kSameForceN) out.judgements.push_back(i);
  }
  return out;
}

Result<Sources> sourcesOfVertex(const study::Study& study, const BuiltModel& built, const BuildSettings& settings,
                                std::string_view variable, std::string_view term, std::size_t point) {
  const auto& model = built.model;
  const fuzzy::Variable* found = variable == model.output.id ? &model.output : nullptr;
  for (const auto& input : model.inputs) {
    if (input.id == variable) found = &input;
  }
  if (found == nullptr) {
    return fail(ErrorCode::kReference, "variable", base::quoted(variable), "an input or the output of the model");
  }
  TACTUS_TRY(const auto index, termIndex(*found, term, point));
  if (found != &model.output && fuzzy::roleOf(*found) == fuzzy::Role::kRate && !built.speeds.empty()) {
    TACTUS_TRY(const auto shares, speedVertexShares(study, built, settings, term, point));
    if (shares.empty()) return without("The vertex is an end of the universe of the speed.");
    Sources out;
    for (const auto& one : shares) join(out.strokes, one.strokes);
    return out;
  }
  if (found == &model.output && built.force_terms) {
    if (settings.force_terms != ForceTermsFrom::kVote) return allJudgements(study, settings);
    const double value_n = found->terms[index].points[point];
    if (value_n <= found->min) return without("The vertex is the beginning of the universe of the force.");
    Sources out = votesBehind(study, built, settings, value_n);
    const auto& between = built.force_terms->interpolated;
    if (std::find(between.begin(), between.end(), term) != between.end()) {
      out.without_records.push_back("No vote gave this term a force: it was placed between its neighbors.");
    }
    return out;
  }
  if (found != &model.output && fuzzy::roleOf(*found) == fuzzy::Role::kWay &&
      settings.depths == DepthsFrom::kMeasured && settings.measured_depths) {
    return without(measuredSentence(*settings.measured_depths));
  }
  return without("The terms of " + found->id + " are defaults of the program.");
}

Result<Sources> sourcesOfRule(const study::Study& study, const BuiltModel& built, std::size_t expert,
                              std::size_t rule) {
  if (expert >= built.experts.size() || rule >= built.experts[expert].origins.size()) {
    return fail(ErrorCode::kReference, "rule", std::to_string(rule) + " of expert " + std::to_string(expert),
                "a rule of the model");
  }
  const auto& of = built.experts[expert];
  Sources out;
  if (of.source == ExpertRules::Source::kAnswers) {
    const auto& origin = of.origins[rule];
    for (std::size_t i = 0; i < study.answers.size(); ++i) {
      const auto& one = study.answers[i];
      if (one.participant == of.participant.code && one.form == origin.form && one.item == origin.item) {
        out.answers.push_back(i);
      }
    }
    return out;
  }
  // The rules of a participant keep the order of the table.
  std::size_t number = 0;
  for (std::size_t i = 0; i < study.rules.size(); ++i) {
    if (study.rules[i].participant != of.participant.code) continue;
    if (number++ == rule) out.rules.push_back(i);
  }
  return out;
}

Result<Sources> sourcesOfForce(const study::Study& study, const BuiltModel& built, const BuildSettings& settings,
                               std::span<const double> inputs) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(built.model));
  TACTUS_TRY(const auto why, analysis::explain(built.model, compiled, inputs));
  Sources out;
  std::set<std::string> words;  // of the output that count somewhere
  for (std::size_t e = 0; e < why.experts.size(); ++e) {
    if (why.experts[e].weight_share == 0) continue;
    for (const auto& rule : why.experts[e].rules) {
      if (!rule.wins) continue;
      words.insert(built.model.experts[e].rules[rule.rule].then);
      const auto sources = sourcesOfRule(study, built, e, rule.rule);
      if (sources) add(out, *sources);
    }
  }
  const auto take = [&](const std::string& variable, const std::string& term, std::size_t point) {
    const auto sources = sourcesOfVertex(study, built, settings, variable, term, point);
    if (sources) add(out, *sources);
  };
  const auto& speed = speedIn(built.model);
  const auto place = static_cast<std::size_t>(&speed - built.model.inputs.data());
  for (const auto& [term, point] : slopesAt(speed.terms, why.inputs[place].value)) {
    take(speed.id, speed.terms[term].id, point);
  }
  for (const auto& term : built.model.output.terms) {
    for (std::size_t p = 0; words.count(term.id) > 0 && p < term.points.size(); ++p) {
      take(built.model.output.id, term.id, p);
    }
  }
  sort(out);
  return out;
}

}  // namespace tactus::elicitation
