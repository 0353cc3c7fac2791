// A finding says where it is by indices and ids: names that look like other names, or like the wording, mislead no
// reader.
#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "app/editing/lint_fixes.h"
#include "app/editing/step_fixes.h"
#include "core/analysis/lint.h"
#include "core/base/random.h"
#include "elicitation/rules/rule_lint.h"

#include "tests/app/editing/sample_models.h"
#include "tests/support/random_model.h"

namespace tactus::editing {
namespace {

using elicitation::RuleFinding;
using fuzzy::ForceModel;

/// Ids that are prefixes of each other, hold spaces, quotes and commas, or read like the words of a finding.
const std::vector<std::string> kNasty = {
    "depth",      "depth rate", "depth at 3", "depth 3 to",         "depth 3",        "\"depth\"", "a, b", "is",
    "x is y",     "expert",     "everywhere", "no rule fires: ",    "mean",           "it's",      "to",   "where",
    "force",      "rate",       "rate fast",  "depth is rate",      "and depth",      "1",         "-1",   "de\\pth",
    "a, depth 1", "tief é",     "%1",         "depth 0 to 1 mm, a", "depth rate fast"};

/// The model with every id replaced: those of variables, experts and terms each by one of kNasty, in a random order.
ForceModel renamed(ForceModel model, base::Random& random) {
  std::vector<std::string> names;
  for (std::string name : kNasty) {
    if (name.back() == ' ') name.pop_back();
    names.push_back(std::move(name));
  }
  const auto shuffle = [&] {
    for (std::size_t i = names.size(); i > 1; --i)
      std::swap(names[i - 1], names[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  };
  std::map<std::string, std::string> variables;
  const auto take_variables = [&] {
    shuffle();
    std::size_t next = 0;
    for (auto& input : model.inputs) variables[input.id] = names[next++];
    variables[model.output.id] = names[next];
  };
  take_variables();
  // Terms of one variable have one name each, in whichever list; those of another variable may have the same.
  std::map<std::string, std::map<std::string, std::string>> terms;
  const auto take_terms = [&](const std::string& variable, const std::vector<fuzzy::Term>& list) {
    auto& known = terms[variable];
    for (const auto& term : list) {
      if (!known.contains(term.id)) known.emplace(term.id, names[known.size()]);
    }
  };
  for (const auto& input : model.inputs) {
    shuffle();
    take_terms(input.id, input.terms);
    for (const auto& expert : model.experts) take_terms(input.id, termsFor(expert, input));
  }
  shuffle();
  take_terms(model.output.id, model.output.terms);
  for (const auto& expert : model.experts) take_terms(model.output.id, termsFor(expert, model.output));

  shuffle();
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    auto& expert = model.experts[e];
    for (auto& own : expert.overrides) {
      for (auto& term : own.terms) term.id = term.label = terms[own.variable][term.id];
      own.variable = variables[own.variable];
    }
    for (auto& rule : expert.rules) {
      for (auto& condition : rule.conditions) {
        condition = {variables[condition.input], terms[condition.input][condition.term]};
      }
      rule.then = terms[model.output.id][rule.then];
    }
    expert.id = expert.label = names[e];
  }
  const auto rename = [&](fuzzy::Variable& variable) {
    for (auto& term : variable.terms) term.id = term.label = terms[variable.id][term.id];
    variable.id = variable.label = variables[variable.id];
  };
  for (auto& input : model.inputs) rename(input);
  rename(model.output);
  return model;
}

/// Everything of a finding that names do not decide.
struct Bare {
  RuleFinding::Kind kind;
  std::vector<std::size_t> experts;
  std::vector<std::size_t> rules;
  std::size_t where;
  std::optional<double> newtons;
  std::vector<double> from, to;
  std::size_t fixes;

  auto operator<=>(const Bare&) const = default;
};

std::size_t indexOf(const ForceModel& model, const std::string& expert) {
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (model.experts[e].id == expert) return e;
  }
  ADD_FAILURE() << expert;
  return model.experts.size();
}

std::vector<Bare> bareFindings(const ForceModel& model, std::size_t region_input) {
  const auto compiled = fuzzy::compile(model).value();
  elicitation::RuleLintSettings settings;
  settings.directions = {{model.inputs[0].id, analysis::Direction::kRises}};
  settings.region_input = model.inputs[region_input].id;
  std::vector<Bare> out;
  std::set<RuleFinding::Kind> kinds;
  for (const auto& finding : elicitation::ruleLint(model, compiled, {}, settings).findings) {
    Bare bare{finding.kind, {}, {}, finding.where.index(), finding.newtons, finding.from, finding.to, 0};
    for (const auto& expert : finding.experts) bare.experts.push_back(indexOf(model, expert));
    for (const auto& source : finding.sources) bare.rules.push_back(source.rule.value_or(0));
    // Of one kind the first stands for all: each fix is compared over the whole universe, which takes long.
    if (kinds.insert(finding.kind).second) bare.fixes = fixesFor(model, compiled, finding).size();
    EXPECT_EQ(finding.place, describe(finding.where, model));
    out.push_back(std::move(bare));
  }
  std::sort(out.begin(), out.end());
  return out;
}

TEST(FindingPlaces, ARenamedModelHasTheSameFindingsAndFixes) {
  base::Random random(20261122);
  std::size_t findings = 0;
  std::size_t fixes = 0;
  for (int i = 0; i < 60; ++i) {
    const ForceModel plain = support::randomModel(random, {false, false});
    const auto region = static_cast<std::size_t>(random.below(static_cast<int>(plain.inputs.size())));
    const auto expected = bareFindings(plain, region);
    EXPECT_EQ(bareFindings(renamed(plain, random), region), expected) << i;
    findings += expected.size();
    for (const auto& one : expected) fixes += one.fixes;
  }
  EXPECT_GT(findings, 500U);
  EXPECT_GT(fixes, 100U);
}

// The region input is `depth`; a term of `depth rate` that no rule uses is no region of it.
TEST(FindingPlaces, AnInputWhoseIdBeginsWithTheRegionInputs) {
  ForceModel model = support::s4AsPrinted();
  auto& rate = model.inputs[3];
  ASSERT_EQ(rate.id, "speed");
  rate.id = "depth rate";
  std::erase_if(model.experts[0].rules, [](const auto& rule) { return rule.conditions[0].term == "fast"; });
  for (auto& rule : model.experts[0].rules) {
    for (auto& condition : rule.conditions) {
      if (condition.input == "speed") condition.input = "depth rate";
    }
  }
  const auto compiled = fuzzy::compile(model).value();
  const auto lint = elicitation::ruleLint(model, compiled);
  std::vector<std::string> unused;
  for (const auto& finding : lint.findings) {
    if (finding.kind != RuleFinding::Kind::kUnusedTerm) continue;
    unused.push_back(finding.place);
    EXPECT_FALSE(fixesFor(model, compiled, finding).empty());
  }
  EXPECT_EQ(unused, std::vector<std::string>{"depth rate fast"});
}

TEST(FindingPlaces, TwoHolesNeverHaveOneName) {
  base::Random random(7);
  for (int i = 0; i < 300; ++i) {
    const ForceModel model = renamed(support::randomModel(random, {false, false}), random);
    std::vector<analysis::Hole> holes;
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      for (auto& hole : analysis::coverage(model, std::span(&e, 1)).holes) {
        // Ends that are not included do not stand in the name.
        for (auto& range : hole.ranges) range.low_included = range.high_included = true;
        if (std::find(holes.begin(), holes.end(), hole) == holes.end()) holes.push_back(std::move(hole));
      }
    }
    std::set<std::string> names;
    for (const auto& hole : holes) EXPECT_TRUE(names.insert(describe(hole, model)).second) << describe(hole, model);
  }
}

// Ranges that read the same unless an id is marked: `a 1 to` at 2, and `a` from 1 to 2.
TEST(FindingPlaces, AnIdThatReadsLikeARangeIsQuotedInTheNameOfAHole) {
  ForceModel model;
  for (const char* id : {"a", "a 1 to", "a 1 to 2 mm, a", "a rate", "\"a\""}) {
    model.inputs.push_back({id, id, "mm", 0, 9, {}});
  }
  const auto at = [&](std::size_t input, double low, double high) {
    analysis::Hole hole;
    for (const auto& one : model.inputs) hole.ranges.push_back({one.id, one.min, one.max, true, true, true});
    hole.ranges[input] = {model.inputs[input].id, low, high, true, true, false};
    return describe(hole, model);
  };
  EXPECT_EQ(at(0, 1, 2), "a 1 to 2 mm");
  EXPECT_EQ(at(1, 2, 2), "\"a 1 to\" 2 mm");
  EXPECT_EQ(at(2, 2, 3), "\"a 1 to 2 mm, a\" 2 to 3 mm");
  EXPECT_EQ(at(3, 2, 3), "a rate 2 to 3 mm");
  EXPECT_EQ(at(4, 2, 3), "\"\"\"a\"\"\" 2 to 3 mm");
}

}  // namespace
}  // namespace tactus::editing
