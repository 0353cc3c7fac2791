#include <algorithm>
#include <set>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/rebase.h"
#include "core/base/check.h"
#include "core/base/text.h"
#include "core/contracts/contract_check.h"

namespace tactus::editing {
namespace {

using fuzzy::ForceModel;
using fuzzy::Rule;
using fuzzy::Term;
using fuzzy::Variable;
using Parts = std::span<const ModelPart* const>;

constexpr auto kNone = "none";

/// The kind that names the edit: of a term that is split the terms, not its rules.
PartKind kindOf(Parts parts) {
  constexpr PartKind kFirst[] = {PartKind::kOwnTerms, PartKind::kTerm, PartKind::kExpert, PartKind::kVertex};
  for (const PartKind kind : kFirst) {
    if (std::any_of(parts.begin(), parts.end(), [&](const ModelPart* part) { return part->kind == kind; })) return kind;
  }
  return parts.front()->kind;
}

std::vector<const ModelPart*> ofKind(Parts parts, PartKind kind) {
  std::vector<const ModelPart*> out;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(out),
               [&](const ModelPart* part) { return part->kind == kind; });
  return out;
}

/// `S4, Insertion depth` for an own list, `Insertion depth` for the shared one.
std::string titleOf(const ForceModel& model, const TermListId& list) {
  ForceModel copy = model;
  const auto open = openList(copy, list);
  return open ? open->title() : list.variable;
}

const Variable& variableOf(const ForceModel& model, const ModelPart& part) {
  return **findVariable(model, part.list.variable);
}

const Term* termOf(const ForceModel& model, const ModelPart& part) {
  const std::vector<Term>* const terms = termsIn(model, part.list);
  return terms == nullptr ? nullptr : findTerm(*terms, part.key);
}

/// Small, weight 0.5, off
std::string ruleText(const ForceModel& model, const ModelPart& part) {
  const auto value = valueIn(model, part);
  if (!value) return "no rule";
  const Rule& rule = std::get<Rule>(*value);
  std::string out = consequentText(model, **findExpert(model, part.expert), rule.then);
  if (rule.weight != 1) out += ", weight " + base::formatNumber(rule.weight);
  if (!rule.enabled) out += ", off";
  return out;
}

std::string termLabels(const ForceModel& model, const std::vector<const ModelPart*>& parts) {
  std::vector<std::string> labels;
  for (const ModelPart* part : parts) {
    const Term* const term = termOf(model, *part);
    if (term != nullptr && std::find(labels.begin(), labels.end(), labelOf(*term)) == labels.end()) {
      labels.push_back(labelOf(*term));
    }
  }
  return base::joined(labels, ", ");
}

std::string shapeText(const ForceModel& model, const ModelPart& part) {
  const Term* const term = termOf(model, part);
  if (term == nullptr) return kNone;
  std::vector<std::string> points;
  for (const double point : term->points) points.push_back(numberText(variableOf(model, part), point));
  return std::string(fuzzy::name(term->shape)) + ' ' + base::joined(points, ", ");
}

/// `125 to 132 mm` for two places, `125, 128, 132 mm` for more.
std::string placesText(const ForceModel& model, const std::vector<const ModelPart*>& parts) {
  std::set<double> places;
  for (const ModelPart* part : parts) {
    if (const auto value = valueIn(model, *part)) places.insert(std::get<double>(*value));
  }
  if (places.empty()) return kNone;
  const Variable& variable = variableOf(model, *parts.front());
  std::vector<std::string> numbers;
  for (const double place : places) numbers.push_back(numberText(variable, place));
  numbers.back() = quantityText(variable, *places.rbegin());
  return base::joined(numbers, numbers.size() == 2 ? " to " : ", ");
}

std::string verticesTitle(const ForceModel& model, const std::vector<const ModelPart*>& parts) {
  const std::string title = titleOf(model, parts.front()->list);
  std::vector<const ModelPart*> terms;
  for (const ModelPart* part : parts) {
    if (terms.empty() || terms.back()->key != part->key) terms.push_back(part);
  }
  if (terms.size() == 1) {
    std::vector<std::string> points;
    for (const ModelPart* part : parts) points.push_back(pointName(termOf(model, *part)->shape, part->point));
    return title + " / " + termLabels(model, terms) + ": " + base::joined(points, ", ");
  }
  if (terms.size() > 2) return title + ": boundaries of " + termLabels(model, terms);
  return title + ": between " + labelOf(*termOf(model, *terms.front())) + " and " +
         labelOf(*termOf(model, *terms.back()));
}

std::string counted(std::size_t number, const std::string& what) {
  return std::to_string(number) + ' ' + what + (number == 1 ? "" : "s");
}

std::string rendererText(const ForceModel& model) {
  if (!model.renderer) return "the usual settings";
  std::vector<std::string> out;
  for (const auto& field : fuzzy::kRendererFields) {
    const double value = *model.renderer.*field.member;
    if (value != fuzzy::RendererParameters{}.*field.member) {
      out.push_back(std::string(field.key) + ' ' + base::formatNumber(value));
    }
  }
  return out.empty() ? "the usual settings" : base::joined(out, ", ");
}

}  // namespace

std::string partsTitle(const ForceModel& before, const ForceModel& after, Parts parts) {
  TACTUS_CHECK(!parts.empty());
  const PartKind kind = kindOf(parts);
  const auto main = ofKind(parts, kind);
  const ModelPart& first = *main.front();
  const ForceModel& with = first.from ? before : after;
  std::string title;
  switch (kind) {
    case PartKind::kImplication: title = "Implication"; break;
    case PartKind::kDefaultForce: title = "Force where no rule fires"; break;
    case PartKind::kRenderer: title = "Feel of the tube"; break;
    case PartKind::kHole: title = "Hole " + first.key; break;
    case PartKind::kContract: title = "Contract"; break;
    case PartKind::kUniverse: title = labelOf(variableOf(before, first)) + ": universe"; break;
    case PartKind::kExpert: title = "Expert " + labelOf(**findExpert(with, first.key)); break;
    case PartKind::kExpertWeight: title = labelOf(**findExpert(before, first.key)) + ": share in the mean"; break;
    case PartKind::kOwnTerms:
      title = labelOf(**findExpert(before, first.expert)) + ", " + labelOf(variableOf(before, first)) + ": own terms";
      break;
    case PartKind::kTerm:
      title = titleOf(before, first.list);
      title += first.from && first.to ? " / " + labelOf(*termOf(before, first)) + ": shape" : ": terms";
      break;
    case PartKind::kVertex: title = verticesTitle(before, main); break;
    case PartKind::kEvent:
      title = titleOf(before, first.list) + " / " + labelOf(*termOf(with, first)) + ": puncture";
      break;
    case PartKind::kTermName:
      title = titleOf(before, first.list) + " / " + labelOf(*termOf(before, first)) + ": name";
      break;
    case PartKind::kRule: {
      const auto expert = *findExpert(with, first.expert);
      const Rule& rule = std::get<Rule>(first.from ? *first.from : *first.to);
      title = labelOf(*expert) + ": " + conditionsText(with, *expert, rule);
      break;
    }
  }
  const std::size_t rules = ofKind(parts, PartKind::kRule).size();
  if (kind != PartKind::kRule && rules > 0) title += ", with " + counted(rules, "rule");
  if (kind == PartKind::kRule && rules > 1) title += " and " + counted(rules - 1, "more rule");
  return title;
}

std::string partsText(const ForceModel& model, Parts parts) {
  const PartKind kind = kindOf(parts);
  const auto main = ofKind(parts, kind);
  const ModelPart& first = *main.front();
  const auto value = valueIn(model, first);
  switch (kind) {
    case PartKind::kImplication: return std::string(fuzzy::name(model.implication));
    case PartKind::kDefaultForce: return quantityText(model.output, model.default_force_n);
    case PartKind::kRenderer: return rendererText(model);
    case PartKind::kHole: return value ? "accepted" : "not accepted";
    case PartKind::kContract: return value ? contracts::sentenceOf(model, std::get<fuzzy::Contract>(*value)) : kNone;
    case PartKind::kUniverse: {
      if (!value) return kNone;
      const auto& range = std::get<UniverseRange>(*value);
      const Variable& variable = variableOf(model, first);
      return numberText(variable, range.min) + " to " + quantityText(variable, range.max);
    }
    case PartKind::kExpert: return value ? "part of the model" : "not part of the model";
    case PartKind::kExpertWeight: return value ? base::formatNumber(std::get<double>(*value)) : kNone;
    case PartKind::kOwnTerms: return value ? "terms of its own" : "the shared terms";
    case PartKind::kTerm: {
      if (first.from && first.to) return shapeText(model, first);
      const std::string labels = termLabels(model, main);
      return labels.empty() ? kNone : labels;
    }
    case PartKind::kVertex: return placesText(model, main);
    case PartKind::kEvent:
      return value ? base::roundedNumber(std::get<double>(*value) * 100) + " % of the force is lost" : kNone;
    case PartKind::kTermName: {
      const Term* const term = termOf(model, first);
      return term == nullptr ? kNone : labelOf(*term);
    }
    case PartKind::kRule: return main.size() == 1 ? ruleText(model, first) : counted(main.size(), "rule");
  }
  return {};
}

std::string tunedText(const ForceModel& after, Parts parts) {
  if (kindOf(parts) != PartKind::kTermName) return partsText(after, parts);
  const auto& names = std::get<TermNames>(*parts.front()->to);
  return names.label.empty() ? names.id : names.label;
}

}  // namespace tactus::editing
