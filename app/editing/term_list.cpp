#include "app/editing/term_list.h"

#include <algorithm>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/term_edits.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::editing {

using base::ErrorCode;
using base::fail;
using base::quoted;
using base::Result;
using fuzzy::Expert;
using fuzzy::ForceModel;

namespace {

template <class List>
std::string idsOf(const List& list) {
  std::vector<std::string> ids;
  ids.reserve(list.size());
  for (const auto& entry : list) ids.push_back(entry.id);
  return base::joined(ids, ", ");
}

auto overrideOf(Expert& expert, std::string_view variable) {
  return std::find_if(expert.overrides.begin(), expert.overrides.end(),
                      [variable](const fuzzy::TermOverride& own) { return own.variable == variable; });
}

template <class Model>
auto expertIn(Model& model, std::string_view id) -> Result<decltype(model.experts.data())> {
  const auto it =
      std::find_if(model.experts.begin(), model.experts.end(), [id](const Expert& expert) { return expert.id == id; });
  if (it == model.experts.end()) {
    return fail(ErrorCode::kReference, "expert", quoted(id), "one of " + idsOf(model.experts));
  }
  return &*it;
}

}  // namespace

std::string OpenList::title() const {
  return expert == nullptr ? labelOf(*variable) + scope : labelOf(*expert) + ", " + labelOf(*variable);
}

Result<const fuzzy::Variable*> findVariable(const ForceModel& model, std::string_view id) {
  for (const auto& input : model.inputs) {
    if (input.id == id) return &input;
  }
  if (model.output.id == id) return &model.output;
  return fail(ErrorCode::kReference, "variable", quoted(id), "one of " + idsOf(model.inputs) + ", " + model.output.id);
}

Result<Expert*> findExpert(ForceModel& model, std::string_view id) { return expertIn(model, id); }
Result<const Expert*> findExpert(const ForceModel& model, std::string_view id) { return expertIn(model, id); }

Result<OpenList> openList(ForceModel& model, const TermListId& list) {
  TACTUS_TRY(const auto variable, findVariable(model, list.variable));
  OpenList out;
  out.variable = variable;
  if (list.expert.empty()) {
    const bool output = variable == &model.output;
    out.terms =
        output ? &model.output.terms : &model.inputs[static_cast<std::size_t>(variable - model.inputs.data())].terms;
    // A model of one expert has one scope, so there is nothing to ask.
    if (model.experts.size() > 1) {
      const std::string readers = readersText(model, list);
      if (!readers.empty()) out.scope = " (" + readers + ')';
    }
    return out;
  }
  TACTUS_TRY(const auto expert, findExpert(model, list.expert));
  const auto own = overrideOf(*expert, list.variable);
  if (own == (expert)->overrides.end()) {
    return fail(ErrorCode::kReference, "terms of " + quoted(list.variable),
                "the shared list for expert " + quoted(list.expert), "an own list of that expert");
  }
  out.expert = expert;
  out.terms = &own->terms;
  return out;
}

Result<std::size_t> findTermIn(const OpenList& list, std::string_view term) {
  const fuzzy::Term* const found = findTerm(*list.terms, term);
  if (found != nullptr) return static_cast<std::size_t>(found - list.terms->data());
  return fail(ErrorCode::kReference, list.title(), quoted(term), "one of " + idsOf(*list.terms));
}

const std::vector<fuzzy::Term>* termsIn(const ForceModel& model, const TermListId& list) {
  const auto variable = findVariable(model, list.variable);
  if (!variable) return nullptr;
  if (list.expert.empty()) return &(*variable)->terms;
  const auto expert = findExpert(model, list.expert);
  return expert && reads(**expert, list) ? &termsFor(**expert, **variable) : nullptr;
}

TermListId listOf(const Expert& expert, std::string_view variable) {
  const bool own = std::any_of(expert.overrides.begin(), expert.overrides.end(),
                               [variable](const fuzzy::TermOverride& entry) { return entry.variable == variable; });
  return {std::string(variable), own ? expert.id : std::string()};
}

std::vector<std::size_t> readersOf(const ForceModel& model, const TermListId& list) {
  std::vector<std::size_t> out;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (reads(model.experts[e], list)) out.push_back(e);
  }
  return out;
}

std::string readersText(const ForceModel& model, const TermListId& list) {
  // More would not fit into a line of the history.
  constexpr std::size_t kMostNamed = 4;
  const auto readers = readersOf(model, list);
  if (readers.size() > kMostNamed) {
    const std::string all = std::to_string(model.experts.size()) + " experts";
    return readers.size() == model.experts.size() ? "all " + all : std::to_string(readers.size()) + " of " + all;
  }
  std::string text;
  for (const std::size_t e : readers) text += (text.empty() ? "" : ", ") + model.experts[e].id;
  return text;
}

bool reads(const Expert& expert, const TermListId& list) { return listOf(expert, list.variable) == list; }

Result<Edit> makeOwn(const ForceModel& model, const TermListId& list) {
  ForceModel out = model;
  TACTUS_TRY(const auto variable, findVariable(out, list.variable));
  TACTUS_TRY(const auto expert, findExpert(out, list.expert));
  if (overrideOf(*expert, list.variable) != (expert)->overrides.end()) {
    return fail(ErrorCode::kValue, labelOf(*expert), "an own list for " + quoted(list.variable) + " already",
                "the shared list");
  }
  const std::string label = labelOf(*expert) + ", " + labelOf(*variable) + ": own terms";
  (expert)->overrides.push_back({list.variable, (variable)->terms});
  return finished(std::move(out), label);
}

Result<Edit> backToShared(const ForceModel& model, const TermListId& list, RulesOfTerm rules) {
  ForceModel out = model;
  TACTUS_TRY(auto open, openList(out, list));
  if (open.expert == nullptr) {
    return fail(ErrorCode::kValue, open.title(), "the shared list", "an expert's own list");
  }
  const std::string label = open.title() + ": back to the shared terms";
  for (const auto& term : *open.terms) {
    if (findTerm(open.variable->terms, term.id) != nullptr) continue;
    if (auto ok = letGo(*open.expert, out, *open.variable, term.id, rules); !ok) return tl::unexpected(ok.error());
  }
  open.expert->overrides.erase(overrideOf(*open.expert, list.variable));
  return finished(std::move(out), label);
}

}  // namespace tactus::editing
