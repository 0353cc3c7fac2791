#include "core/fuzzy/validate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>

#include "core/base/json_pointer.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {
namespace {

using base::childPointer;
using base::ErrorCode;
using base::fail;
using base::formatNumber;
using base::quoted;
using base::Result;

// Larger numbers would overflow in the moments of the output set, narrower universes underflow.
constexpr double kLargest = 1e150;
constexpr double kNarrowest = 1e-150;
// A Gaussian output term weaker than this in the whole universe has no area that a double can hold.
constexpr double kFaintest = 1e-250;
constexpr std::size_t kLongestId = 64;

Result<void> checkNumber(double value, double min, double max, const std::string& place) {
  if (std::isfinite(value) && value >= min && value <= max) return {};
  return fail(ErrorCode::kValue, place, formatNumber(value),
              "a number in [" + formatNumber(min) + ", " + formatNumber(max) + "]");
}

Result<void> checkId(const std::string& id, const std::string& place) {
  const bool control = std::any_of(id.begin(), id.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; });
  if (!id.empty() && id.size() <= kLongestId && !control && base::trimmed(id) == id) return {};
  return fail(ErrorCode::kValue, place, id.empty() ? "an empty id" : quoted(id),
              "an id of 1 to 64 bytes without control characters and without spaces at its ends");
}

/// Checks that `id` is new among `seen` and remembers it.
Result<void> checkUnique(std::set<std::string_view>& seen, const std::string& id, const std::string& place) {
  if (auto ok = checkId(id, place); !ok) return ok;
  if (!seen.insert(id).second) return fail(ErrorCode::kSchema, place, quoted(id) + " twice", "each id once");
  return {};
}

Result<void> checkCount(std::size_t count, std::size_t most, std::string_view what, const std::string& place) {
  if (count >= 1 && count <= most) return {};
  return fail(count == 0 ? ErrorCode::kSchema : ErrorCode::kLimit, place,
              std::to_string(count) + " " + std::string(what), "1 to " + std::to_string(most));
}

Result<void> checkPoints(const Term& term, const std::string& place) {
  const std::string shape(name(term.shape));
  if (term.points.size() != pointCount(term.shape)) {
    return fail(ErrorCode::kSchema, place, std::to_string(term.points.size()) + " numbers",
                std::to_string(pointCount(term.shape)) + " for a " + shape);
  }
  for (std::size_t i = 0; i < term.points.size(); ++i) {
    if (auto ok = checkNumber(term.points[i], -kLargest, kLargest, childPointer(place, i)); !ok) return ok;
  }
  if (term.shape == Shape::kGaussian) {
    if (term.points[1] >= kNarrowest) return {};
    return fail(ErrorCode::kValue, childPointer(place, 1), "sigma " + formatNumber(term.points[1]), "sigma > 0");
  }
  for (std::size_t i = 1; i < term.points.size(); ++i) {
    if (term.points[i] < term.points[i - 1]) {
      return fail(ErrorCode::kValue, childPointer(place, i),
                  formatNumber(term.points[i]) + " after " + formatNumber(term.points[i - 1]),
                  "the points of a " + shape + " in ascending order");
    }
  }
  return {};
}

/// An output term must cover some area of the universe, or its centroid would be 0/0.
Result<void> checkMeetsUniverse(const Term& term, const Variable& output, const std::string& place) {
  const auto f = MembershipFunction::of(term);
  const bool meets = f.gaussian ? f(std::clamp(f.mean, output.min, output.max)) >= kFaintest
                                : std::min(f.d, output.max) > std::max(f.a, output.min);
  if (meets) return {};
  return fail(
      ErrorCode::kValue, place, "an output term without area in its universe",
      "a term that meets [" + formatNumber(output.min) + ", " + formatNumber(output.max) + "] in positive width");
}

Result<void> checkTerms(const std::vector<Term>& terms, const Variable* output, const std::string& place) {
  if (auto ok = checkCount(terms.size(), kMostTerms, "terms", place); !ok) return ok;
  std::set<std::string_view> ids;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const std::string at = childPointer(place, i);
    if (auto ok = checkUnique(ids, terms[i].id, childPointer(at, "id")); !ok) return ok;
    if (auto ok = checkPoints(terms[i], childPointer(at, "points")); !ok) return ok;
    if (output == nullptr) continue;
    if (auto ok = checkMeetsUniverse(terms[i], *output, childPointer(at, "points")); !ok) return ok;
  }
  return {};
}

Result<void> checkUniverse(const Variable& variable, const std::string& place) {
  if (auto ok = checkNumber(variable.min, -kLargest, kLargest, childPointer(place, "min")); !ok) return ok;
  if (auto ok = checkNumber(variable.max, -kLargest, kLargest, childPointer(place, "max")); !ok) return ok;
  if (variable.max - variable.min >= kNarrowest) return {};
  return fail(ErrorCode::kValue, childPointer(place, "max"), formatNumber(variable.max),
              "more than min, which is " + formatNumber(variable.min));
}

/// The variable `id`, or null.
const Variable* findVariable(const ForceModel& model, std::string_view id) {
  if (model.output.id == id) return &model.output;
  const auto it =
      std::find_if(model.inputs.begin(), model.inputs.end(), [id](const Variable& v) { return v.id == id; });
  return it == model.inputs.end() ? nullptr : &*it;
}

Result<void> checkVariables(const ForceModel& model) {
  if (auto ok = checkCount(model.inputs.size(), kMostInputs, "inputs", "/inputs"); !ok) return ok;
  std::set<std::string_view> ids;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const std::string place = childPointer("/inputs", i);
    if (auto ok = checkUnique(ids, model.inputs[i].id, childPointer(place, "id")); !ok) return ok;
    if (auto ok = checkUniverse(model.inputs[i], place); !ok) return ok;
    if (auto ok = checkTerms(model.inputs[i].terms, nullptr, childPointer(place, "terms")); !ok) return ok;
  }
  if (auto ok = checkUnique(ids, model.output.id, "/output/id"); !ok) return ok;
  if (auto ok = checkUniverse(model.output, "/output"); !ok) return ok;
  return checkTerms(model.output.terms, &model.output, "/output/terms");
}

Result<void> checkReference(const std::vector<Term>& terms, const std::string& id, const Variable& variable,
                            const std::string& place) {
  if (findTerm(terms, id) != nullptr) return {};
  std::string known;
  for (const auto& term : terms) known += (known.empty() ? "" : ", ") + term.id;
  return fail(ErrorCode::kReference, place, quoted(id), "a term of " + quoted(variable.id) + ": " + known);
}

/// The rule as a text that is equal for equal rules, whatever the order of their conditions.
std::string ruleKey(const Rule& rule) {
  std::vector<std::string> parts;
  for (const auto& condition : rule.conditions) parts.push_back(condition.input + '\n' + condition.term);
  std::sort(parts.begin(), parts.end());
  return base::joined(parts, "\r") + "\r\r" + rule.then;
}

Result<void> checkRule(const ForceModel& model, const Expert& expert, const Rule& rule, const std::string& place) {
  if (rule.conditions.empty()) {
    return fail(ErrorCode::kSchema, childPointer(place, "if"), "a rule without a condition", "one condition or more");
  }
  std::set<std::string_view> inputs;
  for (const auto& condition : rule.conditions) {
    const std::string at = childPointer(childPointer(place, "if"), condition.input);
    const Variable* const variable = findVariable(model, condition.input);
    if (variable == nullptr || variable == &model.output) {
      return fail(ErrorCode::kReference, at, quoted(condition.input), "the id of an input of the model");
    }
    if (!inputs.insert(condition.input).second) {
      return fail(ErrorCode::kSchema, at, quoted(condition.input) + " twice", "each input once in a rule");
    }
    if (auto ok = checkReference(termsFor(expert, *variable), condition.term, *variable, at); !ok) return ok;
  }
  if (auto ok = checkReference(termsFor(expert, model.output), rule.then, model.output, childPointer(place, "then"));
      !ok)
    return ok;
  return checkNumber(rule.weight, 0, 1, childPointer(place, "weight"));
}

Result<void> checkOverrides(const ForceModel& model, const Expert& expert, const std::string& place) {
  std::set<std::string_view> variables;
  for (const auto& own : expert.overrides) {
    const std::string at = childPointer(place, own.variable);
    const Variable* const variable = findVariable(model, own.variable);
    if (variable == nullptr)
      return fail(ErrorCode::kReference, at, quoted(own.variable), "the id of a variable of the model");
    if (!variables.insert(own.variable).second) {
      return fail(ErrorCode::kSchema, at, quoted(own.variable) + " twice", "one list of terms for a variable");
    }
    if (auto ok = checkTerms(own.terms, variable == &model.output ? variable : nullptr, at); !ok) return ok;
  }
  return {};
}

Result<void> checkExpert(const ForceModel& model, const Expert& expert, const std::string& place) {
  if (auto ok = checkNumber(expert.weight, 0, std::numeric_limits<double>::max(), childPointer(place, "weight")); !ok)
    return ok;
  if (auto ok = checkOverrides(model, expert, childPointer(place, "terms")); !ok) return ok;
  if (expert.rules.size() > kMostRules) {
    return fail(ErrorCode::kLimit, childPointer(place, "rules"), std::to_string(expert.rules.size()) + " rules",
                "at most " + std::to_string(kMostRules));
  }
  std::unordered_set<std::string> seen;
  for (std::size_t i = 0; i < expert.rules.size(); ++i) {
    const std::string at = childPointer(childPointer(place, "rules"), i);
    if (auto ok = checkRule(model, expert, expert.rules[i], at); !ok) return ok;
    if (!seen.insert(ruleKey(expert.rules[i])).second) {
      return fail(ErrorCode::kSchema, at, "a rule with the conditions and the consequent of an earlier one",
                  "each rule once");
    }
  }
  return {};
}

Result<void> checkExperts(const ForceModel& model) {
  if (auto ok = checkCount(model.experts.size(), kMostExperts, "experts", "/experts"); !ok) return ok;
  std::set<std::string_view> ids;
  bool weighty = false;
  for (std::size_t i = 0; i < model.experts.size(); ++i) {
    const std::string place = childPointer("/experts", i);
    if (auto ok = checkUnique(ids, model.experts[i].id, childPointer(place, "id")); !ok) return ok;
    if (auto ok = checkExpert(model, model.experts[i], place); !ok) return ok;
    weighty = weighty || model.experts[i].weight > 0;
  }
  if (!weighty)
    return fail(ErrorCode::kValue, "/experts", "only experts of weight 0", "one expert or more with a weight > 0");
  return {};
}

Result<void> checkRenderer(const RendererParameters& renderer) {
  if (renderer.version != 1) {
    return fail(ErrorCode::kVersion, "/renderer/version", std::to_string(renderer.version), "version 1");
  }
  for (const auto& field : kRendererFields) {
    const double value = renderer.*field.member;
    if (std::isfinite(value) && value <= field.max && (field.min_excluded ? value > field.min : value >= field.min))
      continue;
    return fail(ErrorCode::kValue, childPointer("/renderer", field.key), formatNumber(value),
                "a number in " + std::string(field.min_excluded ? "(" : "[") + formatNumber(field.min) + ", " +
                    formatNumber(field.max) + "]");
  }
  return {};
}

Result<void> checkChecks(const ForceModel& model) {
  for (std::size_t i = 0; i < model.checks.size(); ++i) {
    const std::string place = childPointer("/checks", i);
    const Check& check = model.checks[i];
    if (check.in.size() != model.inputs.size()) {
      return fail(ErrorCode::kSchema, childPointer(place, "in"), std::to_string(check.in.size()) + " numbers",
                  std::to_string(model.inputs.size()) + ", one per input");
    }
    for (std::size_t k = 0; k < check.in.size(); ++k) {
      if (!std::isfinite(check.in[k])) {
        return fail(ErrorCode::kValue, childPointer(childPointer(place, "in"), k), formatNumber(check.in[k]),
                    "a finite number");
      }
    }
    if (!std::isfinite(check.force)) {
      return fail(ErrorCode::kValue, childPointer(place, "force"), formatNumber(check.force), "a finite number");
    }
  }
  return {};
}

}  // namespace

Result<void> validate(const ForceModel& model) {
  if (auto ok = checkVariables(model); !ok) return ok;
  if (auto ok = checkNumber(model.default_force_n, -kLargest, kLargest, "/default_force_n"); !ok) return ok;
  if (auto ok = checkExperts(model); !ok) return ok;
  if (model.renderer) {
    if (auto ok = checkRenderer(*model.renderer); !ok) return ok;
  }
  return checkChecks(model);
}

}  // namespace tactus::fuzzy
