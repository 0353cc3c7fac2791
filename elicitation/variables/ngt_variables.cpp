#include "elicitation/variables/ngt_variables.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/base/check.h"
#include "core/base/json/json_members.h"

namespace tactus::elicitation {

// The data files of this folder, embedded in the program (tactus_embed).

/// data/ngt_variables.json
std::string_view ngtVariablesJson();

namespace {

using base::JsonMembers;
using base::JsonValue;
using base::required;
using Problem = std::optional<base::Error>;

struct NgtData {
  std::vector<DepthTermSet> depth_term_sets;
  std::vector<fuzzy::Variable> inputs;
  fuzzy::Variable output;
  std::vector<DeclaredDirection> directions;
  std::string region_input;
};

std::vector<fuzzy::Term> readTerms(JsonMembers& json, Problem& error) {
  std::vector<fuzzy::Term> terms;
  for (const JsonValue value : json.elements("terms")) {
    JsonMembers members(value, error);
    fuzzy::Term& term = terms.emplace_back();
    term.shape = fuzzy::Shape::kTrapezoid;
    members.text(required("id"), term.id);
    members.text(required("label"), term.label);
    members.numbers(required("points"), term.points);
    members.refuseOthers();
  }
  return terms;
}

fuzzy::Variable readVariable(JsonMembers& json, Problem& error) {
  fuzzy::Variable variable;
  json.text(required("id"), variable.id);
  json.text(required("label"), variable.label);
  json.text(required("unit"), variable.unit);
  json.number(required("min"), variable.min);
  json.number(required("max"), variable.max);
  variable.terms = readTerms(json, error);
  return variable;
}

std::optional<DepthTermSet> find(std::vector<DepthTermSet> sets, std::string_view id) {
  for (auto& set : sets) {
    if (set.id == id) return std::move(set);
  }
  return std::nullopt;
}

void readInput(JsonMembers json, NgtData& data, Problem& error) {
  fuzzy::Variable input = readVariable(json, error);
  std::string set;
  bool regions = false;
  json.text("terms_of_set", set);
  json.flag("regions", regions);
  const auto direction = json.word("declared_direction", std::array<std::string_view, 2>{"falls", "rises"});
  json.refuseOthers();
  if (const auto named = find(data.depth_term_sets, set)) input.terms = named->terms;
  if (input.terms.empty()) json.refuse("terms", "no terms", "terms, or the name of a set of terms");
  if (regions) data.region_input = input.id;
  if (direction) {
    data.directions.push_back({input.id, *direction == 0 ? analysis::Direction::kFalls : analysis::Direction::kRises});
  }
  data.inputs.push_back(std::move(input));
}

NgtData readData(JsonMembers& json, Problem& error) {
  NgtData data;
  for (const JsonValue value : json.elements(required("depth_term_sets"))) {
    JsonMembers members(value, error);
    DepthTermSet& set = data.depth_term_sets.emplace_back();
    members.text(required("id"), set.id);
    members.text(required("label"), set.label);
    set.terms = readTerms(members, error);
    members.refuseOthers();
  }
  for (const JsonValue value : json.elements(required("inputs"))) readInput({value, error}, data, error);
  if (const auto value = json.object(required("output"))) {
    JsonMembers members(*value, error);
    data.output = readVariable(members, error);
    members.refuseOthers();
  }
  json.refuseOthers();
  return data;
}

// The file is part of the program: reading it cannot fail for a reason outside the program.
NgtData data() {
  auto read = base::readJson(ngtVariablesJson(), "ngt_variables.json", readData);
  TACTUS_CHECK(read.has_value() && !read->region_input.empty());
  return std::move(*read);
}

}  // namespace

std::vector<fuzzy::Variable> ngtInputs() { return data().inputs; }

std::vector<std::string> ngtInputIds() {
  std::vector<std::string> ids;
  for (const auto& input : ngtInputs()) ids.push_back(input.id);
  return ids;
}

fuzzy::Variable ngtOutput() { return data().output; }

std::vector<DeclaredDirection> ngtDirections() { return data().directions; }

std::string ngtRegionInput() { return data().region_input; }

std::vector<DepthTermSet> depthTermSets() { return data().depth_term_sets; }

std::optional<DepthTermSet> findDepthTerms(std::string_view id) { return find(depthTermSets(), id); }

}  // namespace tactus::elicitation
