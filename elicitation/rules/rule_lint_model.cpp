#include <algorithm>

#include "core/fuzzy/membership.h"
#include "elicitation/rules/rule_lint_parts.h"
#include "elicitation/rules/rule_missing.h"

namespace tactus::elicitation {
namespace {

using Kind = RuleFinding::Kind;
using Source = RuleFinding::Source;

Kind kindOf(analysis::Finding::Kind kind) {
  using From = analysis::Finding::Kind;
  switch (kind) {
    case From::kHole:
      return Kind::kHole;
    case From::kAbstentionJump:
      return Kind::kAbstentionJump;
    case From::kConflict:
      return Kind::kConflict;
    case From::kRedundantRule:
      return Kind::kRedundantRule;
    case From::kDirectionChange:
      return Kind::kDirectionChange;
    case From::kDisagreement:
      return Kind::kDisagreement;
    case From::kUnusedTerm:
      return Kind::kUnusedTerm;
    case From::kUnreachableTerm:
      return Kind::kUnreachableTerm;
    case From::kUnreachableRule:
      return Kind::kUnreachableRule;
  }
  return Kind::kHole;
}

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
    RuleFinding finding;
    finding.kind = kindOf(from.kind);
    finding.where = from.where;
    finding.place = from.place;
    finding.text = from.text;
    finding.newtons = from.newtons;
    finding.at_least = from.newtons && isSampled(finding.kind);
    finding.from = from.from;
    finding.to = from.to;
    const auto expert = std::find_if(model_.experts.begin(), model_.experts.end(),
                                     [&from](const fuzzy::Expert& one) { return one.id == from.expert; });
    if (expert != model_.experts.end()) {
      finding.experts = {expert->id};
      const auto index = static_cast<std::size_t>(expert - model_.experts.begin());
      if (from.kind == analysis::Finding::Kind::kDirectionChange && told_.contains({index, from.rules})) return;
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
      case Kind::kHole:
        finding.sources = missingIn(expert, std::get<analysis::Hole>(finding.where));
        break;
      case Kind::kDirectionChange:
        if (finding.newtons == 0.0) finding.from = finding.to = {};
        break;
      case Kind::kUnusedTerm:
        linkRegion(finding, expert);
        break;
      default:
        break;
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
      const Kind kind = kindOf(hole.kind);
      const bool jump = kind == Kind::kHole || kind == Kind::kAbstentionJump;
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

}  // namespace tactus::elicitation
