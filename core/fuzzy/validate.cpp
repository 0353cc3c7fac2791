#include "core/fuzzy/validate.h"

#include <cmath>
#include <string>

#include "core/base/text.h"
#include "core/fuzzy/model_checks.h"
#include "core/fuzzy/resolve.h"

namespace tactus::fuzzy {
namespace {

using base::ErrorCode;
using base::fail;
using base::formatNumber;
using base::Result;

Result<void> checkUniverse(const Variable& variable, const Place& place) {
  if (auto ok = checkNumber(variable.min, -kLargest, kLargest, place["min"]); !ok) return ok;
  if (auto ok = checkNumber(variable.max, -kLargest, kLargest, place["max"]); !ok) return ok;
  if (variable.max - variable.min >= kNarrowest) return {};
  return fail(ErrorCode::kValue, place["max"].text(), formatNumber(variable.max),
              "more than min, which is " + formatNumber(variable.min));
}

Result<void> checkVariables(const ForceModel& model) {
  const Place root;
  const Place inputs = root["inputs"];
  const Place output = root["output"];
  if (auto ok = checkCount(model.inputs.size(), kMostInputs, "inputs", inputs); !ok) return ok;
  NameList ids;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const Place place = inputs[i];
    if (auto ok = checkUnique(ids, model.inputs[i].id, place["id"]); !ok) return ok;
    if (auto ok = checkUniverse(model.inputs[i], place); !ok) return ok;
    if (auto ok = checkTerms(model.inputs[i].terms, nullptr, place["terms"]); !ok) return ok;
  }
  if (auto ok = checkUnique(ids, model.output.id, output["id"]); !ok) return ok;
  if (auto ok = checkUniverse(model.output, output); !ok) return ok;
  return checkTerms(model.output.terms, &model.output, output["terms"]);
}

Result<void> checkRenderer(const RendererParameters& renderer) {
  if (renderer.version != 1) {
    return fail(ErrorCode::kVersion, "/renderer/version", std::to_string(renderer.version), "version 1");
  }
  for (const auto& field : kRendererFields) {
    const double value = renderer.*field.member;
    if (std::isfinite(value) && value <= field.max && (field.min_excluded ? value > field.min : value >= field.min))
      continue;
    return fail(ErrorCode::kValue, "/renderer/" + std::string(field.key), formatNumber(value),
                "a number in " + std::string(field.min_excluded ? "(" : "[") + formatNumber(field.min) + ", " +
                    formatNumber(field.max) + "]");
  }
  return {};
}

Result<void> checkChecks(const ForceModel& model) {
  const Place root;
  const Place all = root["checks"];
  for (std::size_t i = 0; i < model.checks.size(); ++i) {
    const Place place = all[i];
    const Check& check = model.checks[i];
    if (check.in.size() != model.inputs.size()) {
      return fail(ErrorCode::kSchema, place["in"].text(), std::to_string(check.in.size()) + " numbers",
                  std::to_string(model.inputs.size()) + ", one per input");
    }
    for (std::size_t k = 0; k < check.in.size(); ++k) {
      if (!std::isfinite(check.in[k])) {
        return fail(ErrorCode::kValue, place["in"][k].text(), formatNumber(check.in[k]), "a finite number");
      }
    }
    if (!std::isfinite(check.force)) {
      return fail(ErrorCode::kValue, place["force"].text(), formatNumber(check.force), "a finite number");
    }
  }
  return {};
}

}  // namespace

Result<void> validate(const ForceModel& model) {
  std::vector<RuleTable> unused;
  return resolve(model, unused);
}

Result<void> resolve(const ForceModel& model, std::vector<RuleTable>& experts) {
  const Place root;
  if (auto ok = checkVariables(model); !ok) return ok;
  if (auto ok = checkNumber(model.default_force_n, -kLargest, kLargest, root["default_force_n"]); !ok) return ok;
  if (auto ok = resolveExperts(model, experts); !ok) return ok;
  if (model.renderer) {
    if (auto ok = checkRenderer(*model.renderer); !ok) return ok;
  }
  return checkChecks(model);
}

}  // namespace tactus::fuzzy
