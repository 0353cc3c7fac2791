#include "app/editing/rule_grid.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/rule_edits.h"
#include "app/editing/term_list.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {
namespace {

using base::ErrorCode;
using fuzzy::Condition;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;
using fuzzy::Term;
using fuzzy::Variable;

constexpr std::size_t kMostRules = 10'000;

/// Words with one space between them.
std::string spaced(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\r';
    if (!space) {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  if (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

/// Reads one line from left to right. A label may hold the words of the language itself (`Well and wet`): of all names
/// that fit the longest one counts.
class LineReader {
 public:
  LineReader(const ForceModel& model, const Expert& expert, const std::string& line, std::size_t number)
      : model_(model), expert_(expert), line_(line), low_(base::lowered(line)), number_(number) {}

  base::Result<Rule> read() {
    Rule rule;
    rule.enabled = !take("off ");
    if (!take("if ")) return wanted("IF or OFF IF");
    do {
      TACTUS_TRY(auto condition, readCondition());
      rule.conditions.push_back(std::move(condition));
    } while (take(" and "));
    if (!take(" then ")) return wanted("AND or THEN");
    // The output's name may be left out, as on the screen.
    if (const auto length = nameLength(model_.output)) {
      at_ += length;
      if (!take(" is ")) return wanted("\"is\" behind " + labelOf(model_.output));
    }
    TACTUS_TRY(const auto then, readTerm(model_.output));
    rule.then = then;
    if (take(" with ")) {
      const auto weight = base::parseNumber(std::string_view(line_).substr(at_));
      if (!weight) return wanted("a weight from 0 to 1");
      rule.weight = *weight;
      at_ = line_.size();
    }
    if (at_ < line_.size()) return wanted("WITH a weight, or the end of the line");
    return rule;
  }

 private:
  bool take(std::string_view word) {
    if (low_.compare(at_, word.size(), word) != 0) return false;
    at_ += word.size();
    return true;
  }

  bool endsAt(std::size_t end) const { return end == low_.size() || low_[end] == ' '; }

  /// Length of `name` where it stands here as whole words; 0 if it does not.
  std::size_t fits(const std::string& name) const {
    const std::string wanted = spaced(base::lowered(name));
    return !wanted.empty() && low_.compare(at_, wanted.size(), wanted) == 0 && endsAt(at_ + wanted.size())
               ? wanted.size()
               : 0;
  }

  template <class Named>
  std::size_t nameLength(const Named& named) const {
    return std::max(fits(named.id), fits(named.label));
  }

  base::Result<Condition> readCondition() {
    const Variable* input = nullptr;
    std::size_t longest = 0;
    for (const Variable& one : model_.inputs) {
      const std::size_t length = nameLength(one);
      if (length <= longest) continue;
      longest = length;
      input = &one;
    }
    if (input == nullptr) return unknown("an input", namesOf(model_.inputs), " is ");
    at_ += longest;
    if (!take(" is ")) return wanted("\"is\" behind " + labelOf(*input));
    TACTUS_TRY(auto term, readTerm(*input));
    return Condition{input->id, term};
  }

  base::Result<std::string> readTerm(const Variable& variable) {
    const std::vector<Term>& terms = termsFor(expert_, variable);
    const Term* found = nullptr;
    std::size_t longest = 0;
    for (const Term& one : terms) {
      const std::size_t length = nameLength(one);
      if (length <= longest) continue;
      longest = length;
      found = &one;
    }
    if (found == nullptr) return unknown("a term of " + labelOf(variable), namesOf(terms), " ");
    at_ += longest;
    return found->id;
  }

  template <class Named>
  static std::vector<std::string> namesOf(const std::vector<Named>& all) {
    std::vector<std::string> names;
    for (const Named& one : all) names.push_back(labelOf(one));
    return names;
  }

  tl::unexpected<base::Error> wanted(const std::string& what) const {
    const std::string rest = at_ < line_.size() ? base::quoted(line_.substr(at_)) : std::string("the end of the line");
    return fail(ErrorCode::kSyntax, place(), rest, what);
  }

  tl::unexpected<base::Error> unknown(const std::string& what, const std::vector<std::string>& names,
                                      std::string_view end) const {
    const std::string rest = line_.substr(std::min(at_, line_.size()));
    const std::string word = rest.substr(0, base::lowered(rest).find(end));
    const std::string found = word.empty() ? std::string("the end of the line") : base::quoted(word);
    return fail(ErrorCode::kReference, place(), found, what + base::suggestion(word, names));
  }

  std::string place() const { return "line " + std::to_string(number_); }

  const ForceModel& model_;
  const Expert& expert_;
  const std::string& line_;
  const std::string low_;
  std::size_t number_;
  std::size_t at_ = 0;
};

}  // namespace

std::string rulesAsText(const ForceModel& model, const Expert& expert, std::span<const std::size_t> indices) {
  std::string out;
  for (const std::size_t index : indices) {
    const Rule& rule = expert.rules[index];
    if (!rule.enabled) out += "OFF ";
    out += conditionsText(model, expert, rule) + " THEN " + labelOf(model.output) + " is " +
           consequentText(model, expert, rule.then);
    if (rule.weight != 1) out += " WITH " + base::formatNumber(rule.weight);
    out += '\n';
  }
  return out;
}

base::Result<std::vector<Rule>> rulesFromText(const ForceModel& model, const Expert& expert, std::string_view text) {
  std::vector<Rule> rules;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string line = spaced(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (line.empty()) continue;
    if (rules.size() == kMostRules) {
      return fail(ErrorCode::kLimit, "line " + std::to_string(number), "one more rule",
                  "at most " + std::to_string(kMostRules));
    }
    TACTUS_TRY(auto rule, LineReader(model, expert, line, number).read());
    rules.push_back(std::move(rule));
  }
  if (rules.empty()) return fail(ErrorCode::kData, "text", "no line with a rule", "IF … THEN …, one rule a line");
  return rules;
}

namespace {

using base::ErrorCode;
using base::fail;
using base::Result;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;

struct OpenGrid {
  const Expert* expert = nullptr;
  const fuzzy::Variable* condition = nullptr;
  const fuzzy::Variable* region = nullptr;
};

Result<OpenGrid> open(const ForceModel& model, const GridId& grid) {
  OpenGrid out;
  TACTUS_TRY(const auto expert, findExpert(model, grid.expert));
  out.expert = expert;
  for (const auto& [id, variable] :
       {std::pair{&grid.condition, &out.condition}, std::pair{&grid.region, &out.region}}) {
    TACTUS_TRY(const auto found, findVariable(model, *id));
    if (found == &model.output) {
      return fail(ErrorCode::kReference, "grid", "the output " + *id, "an input");
    }
    *variable = found;
  }
  if (out.condition == out.region) {
    return fail(ErrorCode::kValue, "grid", "the input " + grid.region + " twice", "two inputs");
  }
  return out;
}

Rule ruleOf(const ForceModel& model, const GridId& grid, const CellPlace& cell) {
  Rule rule;
  rule.conditions = {{grid.condition, cell.condition_term}, {grid.region, cell.region_term}};
  return inOrderOfInputs(model, std::move(rule));
}

/// Numbers of the rules with exactly the conditions of `rule`; the one that a cell shows comes first.
std::vector<std::size_t> rulesLike(const Expert& expert, const Rule& rule) {
  std::vector<std::size_t> out;
  for (std::size_t r = 0; r < expert.rules.size(); ++r) {
    if (sameConditions(expert.rules[r], rule)) out.push_back(r);
  }
  std::stable_partition(out.begin(), out.end(), [&](std::size_t r) { return fuzzy::takesPart(expert.rules[r]); });
  return out;
}

/// Index in `cells` of the rule's cell. Nothing where the rule has other conditions.
std::optional<std::size_t> cellOf(const RuleGrid& cells, const GridId& grid, const Rule& rule) {
  if (rule.conditions.size() != 2) return std::nullopt;
  const bool region_first = rule.conditions[0].input == grid.region;
  const fuzzy::Condition& condition = rule.conditions[region_first ? 1 : 0];
  const fuzzy::Condition& region = rule.conditions[region_first ? 0 : 1];
  if (condition.input != grid.condition || region.input != grid.region) return std::nullopt;
  const auto row = std::find(cells.rows.begin(), cells.rows.end(), condition.term);
  const auto column = std::find(cells.columns.begin(), cells.columns.end(), region.term);
  if (row == cells.rows.end() || column == cells.columns.end()) return std::nullopt;
  return static_cast<std::size_t>((row - cells.rows.begin()) * std::ssize(cells.columns) +
                                  (column - cells.columns.begin()));
}

/// Place of a rule in the order of the form: input of the condition, its term, the region. Nothing where the rule
/// belongs to no grid over this region.
std::optional<std::array<std::size_t, 3>> placeInForm(const ForceModel& model, const Expert& expert, const Rule& rule,
                                                      const std::string& region) {
  if (rule.conditions.size() != 2) return std::nullopt;
  std::array<std::size_t, 3> place{};
  bool has_region = false;
  for (const auto& condition : rule.conditions) {
    const auto input = std::find_if(model.inputs.begin(), model.inputs.end(),
                                    [&](const fuzzy::Variable& v) { return v.id == condition.input; });
    if (input == model.inputs.end()) return std::nullopt;
    const auto& terms = termsFor(expert, *input);
    const fuzzy::Term* const term = findTerm(terms, condition.term);
    if (term == nullptr) return std::nullopt;
    const auto number = static_cast<std::size_t>(term - terms.data());
    if (condition.input == region) {
      has_region = true;
      place[2] = number;
    } else {
      place[0] = static_cast<std::size_t>(input - model.inputs.begin());
      place[1] = number;
    }
  }
  return has_region ? std::optional(place) : std::nullopt;
}

void insertInForm(const ForceModel& model, Expert& expert, Rule rule, const std::string& region) {
  const auto place = placeInForm(model, expert, rule, region);
  const auto next = std::find_if(expert.rules.begin(), expert.rules.end(), [&](const Rule& other) {
    const auto there = placeInForm(model, expert, other, region);
    return place && there && *there > *place;
  });
  expert.rules.insert(next, std::move(rule));
}

}  // namespace

std::vector<GridId> gridsOf(const ForceModel& model, const std::string& expert, const std::string& region) {
  std::vector<GridId> out;
  for (const auto& input : model.inputs) {
    if (input.id != region) out.push_back({expert, input.id, region});
  }
  return out;
}

Result<RuleGrid> ruleGrid(const ForceModel& model, const GridId& grid) {
  TACTUS_TRY(const auto found, open(model, grid));
  RuleGrid out;
  for (const auto& term : termsFor(*found.expert, *found.condition)) out.rows.push_back(term.id);
  for (const auto& term : termsFor(*found.expert, *found.region)) out.columns.push_back(term.id);
  out.cells.resize(out.rows.size() * out.columns.size());
  const std::vector<Rule>& rules = found.expert->rules;
  for (std::size_t r = 0; r < rules.size(); ++r) {
    const auto place = cellOf(out, grid, rules[r]);
    if (!place) continue;
    GridCell& cell = out.cells[*place];
    const bool shown_counts = cell.rule && fuzzy::takesPart(rules[*cell.rule]);
    if (shown_counts && fuzzy::takesPart(rules[r])) cell.conflict = true;
    if (cell.rule && (shown_counts || !fuzzy::takesPart(rules[r]))) continue;
    cell = {r, rules[r].then, rules[r].weight, rules[r].enabled, false};
  }
  return out;
}

Result<Edit> setAnswer(const ForceModel& model, const GridId& grid, const CellPlace& cell,
                       const std::optional<std::string>& then) {
  if (const auto ok = open(model, grid); !ok) return tl::unexpected(ok.error());
  ForceModel out = model;
  Expert& expert = **findExpert(out, grid.expert);
  Rule answer = ruleOf(out, grid, cell);
  std::string label = labelOf(expert) + ": " + conditionsText(out, expert, answer) + ": ";
  const auto rules = rulesLike(expert, answer);
  const Rule* const before = rules.empty() ? nullptr : &expert.rules[rules.front()];
  label += before == nullptr ? "no answer" : consequentText(out, expert, before->then);
  if (before != nullptr && then == before->then) {
    label += fuzzy::takesPart(*before) ? ", alone" : ", counts again";
  } else {
    label += " to " + (then ? consequentText(out, expert, *then) : std::string("no answer"));
  }

  std::vector<std::size_t> leaving = rules;
  if (then && !rules.empty()) {
    Rule& kept = expert.rules[rules.front()];
    kept.then = *then;
    kept.enabled = true;
    if (kept.weight == 0) kept.weight = 1;
    leaving.erase(leaving.begin());
  }
  std::sort(leaving.rbegin(), leaving.rend());
  for (const std::size_t r : leaving) expert.rules.erase(expert.rules.begin() + static_cast<std::ptrdiff_t>(r));
  if (then && rules.empty()) {
    answer.then = *then;
    insertInForm(out, expert, std::move(answer), grid.region);
  }
  return finished(std::move(out), std::move(label));
}

}  // namespace tactus::editing
