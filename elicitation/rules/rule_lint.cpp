#include "elicitation/rules/rule_lint.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/analysis/directions.h"
#include "core/analysis/expert_spread.h"
#include "core/analysis/explain.h"
#include "core/analysis/force_steps.h"
#include "core/analysis/rule_table.h"
#include "core/base/check.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"
#include "core/procedure/procedure.h"
#include "elicitation/force/noticeable_force.h"
#include "elicitation/rules/rule_finding.h"

namespace tactus::elicitation {
namespace {

using Kind = RuleFinding::Kind;
using Source = RuleFinding::Source;

/// Newtons that come from looking at settings and not from a formula.
bool isSampled(Kind kind) { return kind != Kind::kConflict && kind != Kind::kRedundantRule; }

class ModelFindings {
 public:
  ModelFindings(const RuleContext& context, const analysis::Lint& lint, const ToldSteps& told)
      : context_(context), model_(context.model), lint_(lint), told_(told) {}

  std::vector<RuleFinding> run() {
    for (const auto& finding : lint_.findings) add(finding);
    return std::move(out_);
  }

 private:
  void add(const analysis::Finding& from) {
    RuleFinding finding{from, {}, {}, from.newtons && isSampled(from.kind)};
    const auto expert = std::find_if(model_.experts.begin(), model_.experts.end(),
                                     [&from](const fuzzy::Expert& one) { return one.id == from.expert; });
    if (expert != model_.experts.end()) {
      finding.experts = {expert->id};
      const auto index = static_cast<std::size_t>(expert - model_.experts.begin());
      if (from.kind == Kind::kDirectionChange && told_.contains({index, from.rules})) return;
      for (const std::size_t rule : from.rules) finding.sources.push_back(context_.source(index, rule));
      link(finding, index);
    }
    if (!finding.sources.empty()) {
      const bool absent = !finding.sources.front().rule;
      finding.text += (absent ? "; no answer to " : "; ") + describe(finding.sources);
    }
    out_.push_back(std::move(finding));
  }

  void link(RuleFinding& finding, std::size_t expert) {
    switch (finding.kind) {
      case Kind::kAbstentionJump:
        finding.text += "; with this expert " + newtonsText(context_.compiled.evaluate(finding.from).force_n) +
                        ", without " + newtonsText(context_.compiled.evaluate(finding.to).force_n);
        [[fallthrough]];
      case Kind::kHole: finding.sources = missingIn(expert, std::get<analysis::Hole>(finding.where)); break;
      case Kind::kDirectionChange:
        if (finding.newtons == 0.0) finding.from = finding.to = {};
        break;
      case Kind::kUnusedTerm: linkRegion(finding, expert); break;
      default: break;
    }
  }

  /// Items without an answer that would have given a rule inside `hole`.
  std::vector<Source> missingIn(std::size_t expert, const analysis::Hole& hole) const {
    std::vector<Source> out;
    for (const auto& item : context_.missing(expert)) {
      if (wouldFireIn(hole, model_, model_.experts[expert], item.conditions)) out.push_back({{}, item.origin});
    }
    return out;
  }

  /// A term of the region input without a rule is a region without a rule: with the largest jump at a hole inside it.
  void linkRegion(RuleFinding& finding, std::size_t expert) const {
    const auto& place = std::get<analysis::TermPlace>(finding.where);
    if (!context_.region_input || place.variable != *context_.region_input) return;
    const auto& input = model_.inputs[place.variable];
    const std::string& region = place.term;
    finding.kind = Kind::kRegionWithoutRule;
    finding.text = "no rule in the " + region;
    for (const auto& item : context_.missing(expert)) {
      const bool about = std::find(item.conditions.begin(), item.conditions.end(),
                                   fuzzy::Condition{input.id, region}) != item.conditions.end();
      if (about) finding.sources.push_back({{}, item.origin});
    }
    const auto membership = fuzzy::MembershipFunction::of(*findTerm(termsFor(model_.experts[expert], input), region));
    for (const auto& hole : lint_.findings) {
      const bool jump = hole.kind == Kind::kHole || hole.kind == Kind::kAbstentionJump;
      if (!jump || hole.expert != model_.experts[expert].id || !hole.newtons) continue;
      if (membership(hole.to[*context_.region_input]) == 0) continue;
      if (finding.newtons && *finding.newtons >= *hole.newtons) continue;
      finding.newtons = hole.newtons;
      finding.at_least = true;
      finding.from = hole.from;
      finding.to = hole.to;
    }
  }

  const RuleContext& context_;
  const fuzzy::ForceModel& model_;
  const analysis::Lint& lint_;
  const ToldSteps& told_;
  std::vector<RuleFinding> out_;
};

}  // namespace

std::vector<RuleFinding> findingsOfModel(const RuleContext& context, const analysis::Lint& lint,
                                         const ToldSteps& told) {
  return ModelFindings(context, lint, told).run();
}

namespace {

bool isAgainst(const RuleContext& context, const analysis::NeighborStep& step) {
  return std::any_of(context.directions.begin(), context.directions.end(), [&](const DeclaredDirection& declared) {
    return declared.input == context.model.inputs[step.input].id &&
           step.levels * static_cast<int>(declared.direction) < 0;
  });
}

bool isJump(const RuleContext& context, const analysis::NeighborStep& step) {
  return step.adjacent && step.levels != 0 && std::abs(step.levels) >= context.settings.jump_levels;
}

/// A step that is worth a finding.
struct ExpertStep {
  std::size_t expert;
  analysis::NeighborStep step;
};

std::vector<ExpertStep> stepsToTell(const RuleContext& context) {
  std::vector<ExpertStep> out;
  for (std::size_t e = 0; e < context.model.experts.size(); ++e) {
    for (std::size_t i = 0; i < context.model.inputs.size(); ++i) {
      for (const auto& step : analysis::neighborSteps(context.model, context.model.experts[e], i)) {
        if (isAgainst(context, step) || isJump(context, step)) out.push_back({e, step});
      }
    }
  }
  return out;
}

}  // namespace

std::vector<RuleFinding> findingsOfSteps(const RuleContext& context, analysis::ForceProbe& probe, ToldSteps& told) {
  const auto steps = stepsToTell(context);
  const std::size_t samples = settingsFor(probe, steps.size());
  std::vector<RuleFinding> out;
  for (const auto& [e, step] : steps) {
    const fuzzy::Expert& who = context.model.experts[e];
    RuleFinding finding;
    setPlace(finding, analysis::StepPlace{e, step}, context.model);
    finding.experts = {who.id};
    finding.sources = {context.source(e, step.before), context.source(e, step.after)};
    if (const auto change = analysis::changeAlong(probe, e, step, samples)) {
      finding.newtons = change->newtons;
      finding.at_least = true;
      // Where other rules outweigh the step everywhere there is no change to point at.
      if (change->newtons > 0) {
        finding.from = change->from;
        finding.to = change->to;
      }
    }
    const auto add = [&](Kind kind, const std::string& says) {
      finding.kind = kind;
      finding.text = says + ": " + finding.place + "; " + describe(finding.sources);
      out.push_back(finding);
    };
    if (isAgainst(context, step)) {
      told.insert({e, {step.before, step.after}});
      add(Kind::kAgainstDeclaration, "against the declared direction");
    }
    if (isJump(context, step)) {
      const int levels = std::abs(step.levels);
      add(Kind::kLevelJump, std::to_string(levels) + (levels == 1 ? " level" : " levels") + " at once");
    }
  }
  return out;
}

namespace {

// Points at which experts are compared: most combinations of the vertices of four inputs.
constexpr std::size_t kMostComparisons = 20000;
// Rules looked at for all of them.
constexpr std::size_t kExpertAllowance = 25'000'000;

/// The rule of each of the two that is strongest at the point, the first of equals.
std::vector<RuleFinding::Source> strongestRules(const RuleContext& context, const analysis::ExpertSpread& spread) {
  const auto explained = analysis::explain(context.model, context.compiled, spread.point);
  TACTUS_CHECK(explained.has_value());
  std::vector<RuleFinding::Source> out;
  for (const std::size_t e : {spread.low, spread.high}) {
    const auto& rules = explained->experts[e].rules;
    const auto strongest = std::max_element(rules.begin(), rules.end(),
                                            [](const auto& x, const auto& y) { return x.strength < y.strength; });
    out.push_back(context.source(e, strongest->rule));
  }
  return out;
}

/// Who of the two has no term for the region, so that the force there comes from another region's rules.
std::string notAsked(const RuleContext& context, const analysis::ExpertSpread& spread) {
  std::string text;
  if (spread.region.empty()) return text;
  for (const std::size_t e : {spread.low, spread.high}) {
    const auto& expert = context.model.experts[e];
    if (findTerm(termsFor(expert, context.model.inputs[*context.region_input]), spread.region) != nullptr) continue;
    text.append("; ").append(expert.id).append(" was not asked about this region");
  }
  return text;
}

}  // namespace

std::vector<RuleFinding> findingsOfExperts(const RuleContext& context, analysis::ForceProbe& probe) {
  std::vector<RuleFinding> out;
  if (context.model.output.unit != "N") return out;
  const std::size_t samples = std::clamp<std::size_t>(kExpertAllowance / probe.costOfMean(), 1, kMostComparisons);
  for (const auto& spread : analysis::expertsApart(probe, context.region_input, justNoticeableDifference,
                                                   context.settings.noticeable_times, samples)) {
    const std::string& low = context.model.experts[spread.low].id;
    const std::string& high = context.model.experts[spread.high].id;
    auto& finding = out.emplace_back();
    finding.kind = Kind::kExpertsApart;
    finding.experts = {low, high};
    finding.sources = strongestRules(context, spread);
    analysis::ConditionPlace where;
    if (!spread.region.empty()) where.conditions = {{context.model.inputs[*context.region_input].id, spread.region}};
    setPlace(finding, std::move(where), context.model);
    finding.text = low + " gives " + newtonsText(spread.low_n) + " by " + describe({finding.sources.front()});
    finding.text += " and " + high + ' ' + newtonsText(spread.high_n) + " by " + describe({finding.sources.back()});
    finding.text += (spread.region.empty() ? "" : " where " + finding.place) + "; ";
    finding.text += spread.mean_far_from_all ? "no expert's force is near their mean of " + newtonsText(spread.mean_n)
                                             : "the mean of " + newtonsText(spread.mean_n) + " is near that of " +
                                                   context.model.experts[spread.nearest].id;
    finding.text += ", one just-noticeable difference is " + newtonsText(justNoticeableDifference(spread.mean_n)) +
                    notAsked(context, spread);
    finding.newtons = spread.high_n - spread.low_n;
    finding.at_least = true;
    finding.from = finding.to = spread.point;
  }
  return out;
}

namespace {

// Rules looked at for all of them: some hundredths of a second.
constexpr std::size_t kCliffAllowance = 40'000'000;
constexpr std::size_t kFewestForces = 1000;

std::string trimmedNumber(double value, int decimals) {
  std::string text = base::formatFixed(value, decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string withUnit(const std::string& number, const std::string& unit) {
  return unit == "1" || unit.empty() ? number : number + ' ' + unit;
}

/// `lubrication 1, speed 50 mm/s`: the values of the other inputs.
std::string settingText(const fuzzy::ForceModel& model, const analysis::ForceStep& step) {
  std::string text;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (i == step.input) continue;
    if (!text.empty()) text += ", ";
    text += model.inputs[i].id + ' ' + withUnit(base::formatNumber(step.from[i]), model.inputs[i].unit);
  }
  return text;
}

}  // namespace

std::vector<RuleFinding> findingsOfCliffs(const RuleContext& context, analysis::ForceProbe& probe) {
  std::vector<RuleFinding> out;
  if (context.model.output.unit != "N") return out;
  const auto limits = forceStepLimits(context.model);
  const std::size_t forces = std::max(kFewestForces, kCliffAllowance / (2 * probe.costOfMean()));
  for (const auto& step : analysis::forceSteps(probe, limits, forces)) {
    const fuzzy::Variable& input = context.model.inputs[step.input];
    auto& finding = out.emplace_back();
    finding.kind = Kind::kForceStep;
    if (step.expert) finding.expert = context.model.experts[*step.expert].id;
    if (step.expert) finding.experts = {finding.expert};
    setPlace(finding, analysis::CliffPlace{step.input, step.from[step.input], step.to[step.input]}, context.model);
    finding.text = "the force steps from " + newtonsText(step.from_n) + " to " + newtonsText(step.to_n) + " within " +
                   withUnit(trimmedNumber(step.to[step.input] - step.from[step.input], 2), input.unit) + ", " +
                   base::formatFixed(step.noticeable, 1) + " just-noticeable differences";
    if (step.noticeable <= 1) {
      finding.text +=
          " but steeper than the renderer's stiffness of " + base::formatNumber(limits.stiffness_n_mm) + " N/mm";
    }
    finding.text += ": " + finding.place;
    if (const auto setting = settingText(context.model, step); !setting.empty()) finding.text += " where " + setting;
    finding.newtons = std::abs(step.to_n - step.from_n);
    finding.at_least = context.model.inputs.size() > 1;
    finding.from = step.from;
    finding.to = step.to;
  }
  return out;
}

namespace {

// Rules looked at for the newtons, well below a second also where there are many.
constexpr std::size_t kAllowance = 100'000'000;
// Settings of the inputs that a rule does not mention: enough for all combinations of two inputs of three terms.
constexpr std::size_t kMostSettings = 400;

/// Items without an answer, with what the answer could change.
std::vector<RuleFinding> findingsOfMissingItems(const RuleContext& context, const analysis::ForceProbe& probe) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < context.model.experts.size(); ++e) count += context.missing(e).size();
  // Each possible answer is looked at.
  const std::size_t samples = settingsFor(probe, count * context.model.output.terms.size());
  std::vector<RuleFinding> out;
  for (std::size_t e = 0; e < context.model.experts.size(); ++e) {
    for (const auto& item : context.missing(e)) {
      auto& finding = out.emplace_back();
      finding.kind = Kind::kMissingItem;
      finding.experts = {context.model.experts[e].id};
      finding.sources = {{{}, item.origin}};
      setPlace(finding, analysis::ConditionPlace{item.conditions}, context.model);
      finding.text =
          "no rule for " + finding.place + ": " + describe(finding.sources) + ", " + std::string(name(item.reason));
      const auto stake = answerStake(probe, e, item.conditions, samples);
      if (!stake) continue;
      finding.newtons = stake->newtons;
      finding.at_least = true;
      finding.from = finding.to = stake->point;
    }
  }
  return out;
}

}  // namespace

void setPlace(RuleFinding& finding, analysis::FindingPlace where, const fuzzy::ForceModel& model) {
  finding.place = analysis::describe(where, model);
  finding.where = std::move(where);
}

std::string newtonsText(double force_n) { return base::formatFixed(force_n, 3) + " N"; }

std::size_t settingsFor(const analysis::ForceProbe& probe, std::size_t places) {
  const std::size_t share = kAllowance / (1 + 8 * places * probe.costOfMean());
  return std::clamp<std::size_t>(share, 1, kMostSettings);
}

std::vector<DeclaredDirection> declaredDirections(const fuzzy::ForceModel& model) {
  std::vector<DeclaredDirection> out;
  for (const auto& [input, declared] : procedure::procedureOf(model).directions) {
    if (declared == procedure::Direction::kNone) continue;
    out.push_back(
        {input, declared == procedure::Direction::kFalls ? analysis::Direction::kFalls : analysis::Direction::kRises});
  }
  return out;
}

RuleLint ruleLint(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                  std::span<const ExpertRules> origins, const RuleLintSettings& settings, const std::stop_token& stop) {
  TACTUS_CHECK(origins.empty() || origins.size() == model.experts.size());
  RuleContext context{model,
                      compiled,
                      origins,
                      settings,
                      settings.directions ? *settings.directions : declaredDirections(model),
                      settings.region_input ? std::nullopt : fuzzy::wayOf(model.inputs)};
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (model.inputs[i].id == settings.region_input) context.region_input = i;
  }
  analysis::ForceProbe probe(model, compiled, kAllowance, stop);
  RuleLint out;
  const auto add = [&out](std::vector<RuleFinding> findings) {
    std::move(findings.begin(), findings.end(), std::back_inserter(out.findings));
  };
  ToldSteps told;
  add(findingsOfSteps(context, probe, told));
  add(findingsOfExperts(context, probe));
  out.model = analysis::lint(model, compiled, stop);
  add(findingsOfModel(context, out.model, told));
  add(findingsOfMissingItems(context, probe));
  // Of its own: the newtons of the other findings do not suffer.
  analysis::ForceProbe cliffs(model, compiled, kAllowance, stop);
  add(findingsOfCliffs(context, cliffs));
  out.newtons_complete = out.model.newtons_complete && probe.affords();
  std::stable_sort(out.findings.begin(), out.findings.end(), [](const RuleFinding& x, const RuleFinding& y) {
    return std::pair{x.kind, -x.newtons.value_or(-1)} < std::pair{y.kind, -y.newtons.value_or(-1)};
  });
  return out;
}

}  // namespace tactus::elicitation
