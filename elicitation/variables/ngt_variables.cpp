#include "elicitation/variables/ngt_variables.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/check.h"
#include "elicitation/variables/embedded_data.h"

namespace tactus::elicitation {
namespace {

using nlohmann::json;

// The file is part of the program: reading it cannot fail for a reason outside the program.
json data() { return json::parse(ngtVariablesJson()); }

std::vector<fuzzy::Term> readTerms(const json& list) {
  std::vector<fuzzy::Term> terms;
  for (const auto& term : list) {
    terms.push_back({term.at("id"), term.at("label"), fuzzy::Shape::kTrapezoid, term.at("points")});
  }
  return terms;
}

std::vector<DepthTermSet> readSets(const json& all) {
  std::vector<DepthTermSet> sets;
  for (const auto& set : all.at("depth_term_sets")) {
    sets.push_back({set.at("id"), set.at("label"), readTerms(set.at("terms"))});
  }
  return sets;
}

std::optional<DepthTermSet> find(std::vector<DepthTermSet> sets, std::string_view id) {
  for (auto& set : sets) {
    if (set.id == id) return std::move(set);
  }
  return std::nullopt;
}

fuzzy::Variable readVariable(const json& all, const json& variable) {
  fuzzy::Variable out{variable.at("id"),  variable.at("label"), variable.at("unit"),
                      variable.at("min"), variable.at("max"),   {}};
  if (variable.contains("terms")) {
    out.terms = readTerms(variable.at("terms"));
  } else {
    auto set = find(readSets(all), variable.at("terms_of_set").get<std::string>());
    TACTUS_CHECK(set.has_value());
    out.terms = std::move(set->terms);
  }
  return out;
}

}  // namespace

std::vector<fuzzy::Variable> ngtInputs() {
  const json all = data();
  std::vector<fuzzy::Variable> inputs;
  for (const auto& variable : all.at("inputs")) inputs.push_back(readVariable(all, variable));
  return inputs;
}

std::vector<std::string> ngtInputIds() {
  std::vector<std::string> ids;
  for (const auto& input : ngtInputs()) ids.push_back(input.id);
  return ids;
}

fuzzy::Variable ngtOutput() {
  const json all = data();
  return readVariable(all, all.at("output"));
}

std::vector<DeclaredDirection> ngtDirections() {
  const json all = data();
  std::vector<DeclaredDirection> out;
  for (const auto& input : all.at("inputs")) {
    if (!input.contains("declared_direction")) continue;
    const std::string direction = input.at("declared_direction");
    TACTUS_CHECK(direction == "falls" || direction == "rises");
    out.push_back({input.at("id"), direction == "falls" ? analysis::Direction::kFalls : analysis::Direction::kRises});
  }
  return out;
}

std::string ngtRegionInput() {
  const json all = data();
  const auto& inputs = all.at("inputs");
  const auto it =
      std::find_if(inputs.begin(), inputs.end(), [](const json& input) { return input.contains("regions"); });
  TACTUS_CHECK(it != inputs.end());
  return it->at("id");
}

std::vector<DepthTermSet> depthTermSets() { return readSets(data()); }

std::optional<DepthTermSet> findDepthTerms(std::string_view id) { return find(depthTermSets(), id); }

}  // namespace tactus::elicitation
