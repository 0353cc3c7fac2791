#include "app/workbench/model/finding_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

using elicitation::RuleFinding;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Variable;
using Kind = RuleFinding::Kind;

struct FindingNames {
  Q_DECLARE_TR_FUNCTIONS(FindingWords)
};

}  // namespace

QString kindText(RuleFinding::Kind kind) {
  switch (kind) {
    case Kind::kHole:
      return FindingNames::tr("Hole");
    case Kind::kAbstentionJump:
      return FindingNames::tr("Mean jumps");
    case Kind::kForceStep:
      return FindingNames::tr("Force steps");
    case Kind::kRegionWithoutRule:
      return FindingNames::tr("Region without a rule");
    case Kind::kMissingItem:
      return FindingNames::tr("Missing answer");
    case Kind::kConflict:
      return FindingNames::tr("Conflict");
    case Kind::kExpertsApart:
      return FindingNames::tr("Experts apart");
    case Kind::kAgainstDeclaration:
      return FindingNames::tr("Against the declaration");
    case Kind::kLevelJump:
      return FindingNames::tr("Level jump");
    case Kind::kDirectionChange:
      return FindingNames::tr("Change of direction");
    case Kind::kDisagreement:
      return FindingNames::tr("Disagreement");
    case Kind::kRedundantRule:
      return FindingNames::tr("Redundant rule");
    case Kind::kUnreachableRule:
      return FindingNames::tr("Rule never fires");
    case Kind::kUnreachableTerm:
      return FindingNames::tr("Unreachable term");
    case Kind::kUnusedTerm:
      return FindingNames::tr("Unused term");
  }
  return {};
}

QString findingWho(const ForceModel& model, const RuleFinding& finding) {
  QStringList out;
  for (const std::string& id : finding.experts) {
    for (const Expert& expert : model.experts) {
      if (expert.id == id) out << labelOf(expert);
    }
  }
  return out.isEmpty() ? FindingNames::tr("Mean") : out.join(FindingNames::tr(" and "));
}

QString holeText(const ForceModel& model, const analysis::Hole& hole) {
  return text(analysis::describe(hole, model, [](const Variable& input) { return labelOf(input).toStdString(); }));
}

const Expert* expertOf(const ForceModel& model, const RuleFinding& finding) {
  if (finding.experts.empty()) return nullptr;
  const auto it = std::find_if(model.experts.begin(), model.experts.end(),
                               [&](const Expert& expert) { return expert.id == finding.experts.front(); });
  return it == model.experts.end() ? nullptr : &*it;
}

PlacedTerm termOfFinding(const ForceModel& model, const RuleFinding& finding) {
  const auto* const place = std::get_if<analysis::TermPlace>(&finding.where);
  const Expert* const expert = expertOf(model, finding);
  if (place == nullptr || expert == nullptr) return {};
  const fuzzy::Term* const term = analysis::termAt(finding.where, model, *expert);
  return term == nullptr ? PlacedTerm{} : PlacedTerm{&analysis::variableAt(model, place->variable), term};
}

}  // namespace tactus::workbench
