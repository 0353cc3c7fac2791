#include "app/workbench/tune/findings/shown_finding.h"

#include <QCoreApplication>
#include <algorithm>
#include <tuple>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/finding_words.h"
#include "core/analysis/rule_table.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::workbench {
namespace {

using elicitation::RuleFinding;
using fuzzy::ForceModel;
using FindingKind = RuleFinding::Kind;
using Place = std::vector<std::optional<double>>;

struct ShownFindingText {
  Q_DECLARE_TR_FUNCTIONS(ShownFindingText)
};

class Shower {
 public:
  Shower(const ForceModel& model, const fuzzy::CompiledModel& compiled) : model_(model), compiled_(compiled) {}

  ShownFinding show(const RuleFinding& finding) const {
    ShownFinding out;
    out.finding = finding;
    out.group = groupOf(finding.kind);
    out.kind = kindText(finding.kind);
    out.who = findingWho(model_, finding);
    out.sentence = findingSentence(model_, compiled_, finding);
    out.rules = rulesOf(finding);
    if (finding.newtons && model_.output.unit == "N") out.noticeable = noticeable(finding);
    if (!finding.to.empty()) {
      out.at.assign(finding.to.begin(), finding.to.end());
      if (finding.from != finding.to) out.other_end.assign(finding.from.begin(), finding.from.end());
    } else {
      out.at = placeWithoutForce(finding);
    }
    out.step = stepOf(finding);
    const auto input = analysis::inputOf(finding.where, model_);
    if (input && *input < out.at.size() && out.at[*input]) out.along = {*input, *out.at[*input]};
    return out;
  }

 private:
  QString stepOf(const RuleFinding& finding) const {
    const auto* const place = std::get_if<analysis::StepPlace>(&finding.where);
    if (place == nullptr || place->expert >= model_.experts.size()) return {};
    const fuzzy::Expert& expert = model_.experts[place->expert];
    const fuzzy::Variable& input = model_.inputs[place->step.input];
    const auto term_of = [&](std::size_t rule) {
      for (const fuzzy::Condition& condition : expert.rules[rule].conditions) {
        if (condition.input != input.id) continue;
        const fuzzy::Term* const term = fuzzy::findTerm(fuzzy::termsFor(expert, input), condition.term);
        return term == nullptr ? text(condition.term) : labelOf(*term);
      }
      return QString();
    };
    return ShownFindingText::tr("%1 → %2").arg(term_of(place->step.before), term_of(place->step.after));
  }

  std::vector<RuleOfExpert> rulesOf(const RuleFinding& finding) const {
    std::vector<RuleOfExpert> out;
    for (std::size_t s = 0; s < finding.sources.size(); ++s) {
      if (!finding.sources[s].rule || finding.experts.empty()) continue;
      // Of experts who are apart it is one rule of each.
      const bool one_each = finding.kind == FindingKind::kExpertsApart && s < finding.experts.size();
      out.push_back({one_each ? finding.experts[s] : finding.experts.front(), *finding.sources[s].rule});
    }
    return out;
  }

  /// A force that the change begins with. Of experts who are apart it is their mean, as in the lint.
  std::optional<double> before(const RuleFinding& finding) const {
    if (finding.kind == FindingKind::kConflict) return smallerConsequent(finding);
    if (finding.from.empty()) return std::nullopt;
    const fuzzy::Expert* const expert = expertOf(model_, finding);
    const bool of_mean =
        expert == nullptr || finding.kind == FindingKind::kAbstentionJump || finding.kind == FindingKind::kExpertsApart;
    const auto force = [&](const std::vector<double>& point) {
      if (of_mean) return compiled_.evaluate(point);
      return compiled_.evaluateExpert(static_cast<std::size_t>(expert - model_.experts.data()), point);
    };
    const auto here = force(finding.from);
    // The hand goes over a step either way.
    if (finding.kind == FindingKind::kForceStep) return std::min(here.force_n, force(finding.to).force_n);
    return here.fired ? here.force_n : force(finding.to).force_n;
  }

  std::optional<double> smallerConsequent(const RuleFinding& finding) const {
    const fuzzy::Expert* const expert = expertOf(model_, finding);
    std::optional<double> smallest;
    for (const auto& source : finding.sources) {
      if (expert == nullptr || !source.rule || *source.rule >= expert->rules.size()) continue;
      const auto* const term = fuzzy::findTerm(termsFor(*expert, model_.output), expert->rules[*source.rule].then);
      if (term == nullptr) continue;
      const double force_n = analysis::forceOfTerm(model_, *term, 1);
      smallest = std::min(smallest.value_or(force_n), force_n);
    }
    return smallest;
  }

  double noticeable(const RuleFinding& finding) const {
    return *finding.newtons / elicitation::justNoticeableDifference(std::max(0.0, before(finding).value_or(0)));
  }

  /// Where the conditions of its first rule hold, or in the middle of its term.
  Place placeWithoutForce(const RuleFinding& finding) const {
    const fuzzy::Expert* const expert = expertOf(model_, finding);
    if (expert == nullptr || finding.kind == FindingKind::kUnreachableRule ||
        finding.kind == FindingKind::kUnreachableTerm)
      return {};
    Place out(model_.inputs.size());
    bool any = false;
    const auto set = [&](const std::string& id, const std::string& term_id) {
      for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
        const fuzzy::Variable& input = model_.inputs[i];
        if (input.id != id) continue;
        const auto* const term = fuzzy::findTerm(termsFor(*expert, input), term_id);
        if (term == nullptr) continue;
        out[i] = analysis::peakPosition(*term, input.min, input.max);
        any = true;
      }
    };
    const auto [variable, term] = termOfFinding(model_, finding);
    if (term != nullptr) {
      set(variable->id, term->id);
    } else if (!finding.sources.empty() && finding.sources.front().rule &&
               *finding.sources.front().rule < expert->rules.size()) {
      for (const auto& condition : expert->rules[*finding.sources.front().rule].conditions) {
        set(condition.input, condition.term);
      }
    }
    return any ? out : Place();
  }

  const ForceModel& model_;
  const fuzzy::CompiledModel& compiled_;
};

/// Holes by their names, and what only exists because of them.
void markAccepted(std::vector<ShownFinding>& findings, const ForceModel& model) {
  const auto& accepted = model.accepted_holes;
  const auto isAccepted = [&](const std::string& name) {
    return std::find(accepted.begin(), accepted.end(), name) != accepted.end();
  };
  for (ShownFinding& shown : findings) {
    const FindingKind kind = shown.finding.kind;
    bool yes = (kind == FindingKind::kHole || kind == FindingKind::kAbstentionJump) && isAccepted(shown.finding.place);
    if (kind == FindingKind::kRegionWithoutRule && !shown.finding.to.empty()) {
      // Its newtons are those of a hole inside it.
      yes = std::any_of(findings.begin(), findings.end(), [&](const ShownFinding& hole) {
        return (hole.finding.kind == FindingKind::kHole || hole.finding.kind == FindingKind::kAbstentionJump) &&
               hole.finding.experts == shown.finding.experts && hole.finding.to == shown.finding.to &&
               isAccepted(hole.finding.place);
      });
    }
    if (yes) shown.acceptance = Acceptance::kAccepted;
  }
}

void addLapsed(std::vector<ShownFinding>& findings, const ForceModel& model, bool coverage_complete) {
  // Where the search for holes was cut off, the hole may be one that was not found.
  if (!coverage_complete) return;
  for (const std::string& name : model.accepted_holes) {
    const bool there = std::any_of(findings.begin(), findings.end(), [&](const ShownFinding& shown) {
      return shown.finding.kind == FindingKind::kHole && shown.finding.place == name;
    });
    if (there) continue;
    ShownFinding shown;
    shown.finding.kind = FindingKind::kHole;
    shown.finding.place = name;
    shown.kind = ShownFindingText::tr("Acceptance");
    shown.who = ShownFindingText::tr("Model");
    // All that is left of the hole is its name.
    shown.sentence = ShownFindingText::tr("Accepted, but there is no such hole any more: %1").arg(text(name));
    shown.acceptance = Acceptance::kLapsed;
    findings.push_back(std::move(shown));
  }
}

}  // namespace

FindingGroup groupOf(FindingKind kind) {
  switch (kind) {
    case FindingKind::kHole:
    case FindingKind::kAbstentionJump:
    case FindingKind::kRegionWithoutRule:
    case FindingKind::kMissingItem: return FindingGroup::kCoverage;
    case FindingKind::kConflict:
    case FindingKind::kExpertsApart:
    case FindingKind::kDisagreement: return FindingGroup::kConflict;
    case FindingKind::kAgainstDeclaration:
    case FindingKind::kLevelJump:
    case FindingKind::kDirectionChange:
    case FindingKind::kForceStep: return FindingGroup::kDirection;
    case FindingKind::kRedundantRule:
    case FindingKind::kUnreachableRule:
    case FindingKind::kUnreachableTerm:
    case FindingKind::kUnusedTerm: break;
  }
  return FindingGroup::kNeedless;
}

std::vector<ShownFinding> shownFindings(const ForceModel& model, const fuzzy::CompiledModel& compiled,
                                        const elicitation::RuleLint& lint) {
  const Shower shower(model, compiled);
  std::vector<ShownFinding> out;
  for (const RuleFinding& finding : lint.findings) out.push_back(shower.show(finding));
  markAccepted(out, model);
  addLapsed(out, model, lint.model.coverage_complete);
  std::stable_sort(out.begin(), out.end(), [](const ShownFinding& one, const ShownFinding& other) {
    return std::pair{one.acceptance, -one.finding.newtons.value_or(-1)} <
           std::pair{other.acceptance, -other.finding.newtons.value_or(-1)};
  });
  return out;
}

}  // namespace tactus::workbench
