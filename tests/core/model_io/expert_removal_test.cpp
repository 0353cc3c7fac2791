#include "core/model_io/expert_removal.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"

#include "tests/support/ngt_model.h"

namespace tactus::model_io {
namespace {

using fuzzy::Expert;
using fuzzy::ForceModel;
using Names = std::vector<std::string>;

/// Four experts with the printed rules and weights of their own, and their names everywhere a model can hold them.
ForceModel study() {
  ForceModel model = support::s4AsPrinted();
  const Expert printed = model.experts.front();
  model.experts.clear();
  const char* ids[] = {"velvet-otter", "calm-fox", "calm-fox-2", "S4"};
  for (int e = 0; e < 4; ++e) {
    Expert expert = printed;
    expert.id = ids[e];
    expert.label = std::string(ids[e]) + " (simulated)";
    expert.weight = 1 + e;
    expert.rules.resize(10 + static_cast<std::size_t>(e));
    expert.rules.front().weight = 0.123456 + 0.1 * e;
    if (e < 2) {
      expert.overrides.push_back({"depth", model.inputs[2].terms});
      expert.overrides.front().terms.front().label = std::string(ids[1 - e]) + "'s nose";
    }
    model.experts.push_back(std::move(expert));
  }
  model.name = "Mean of velvet-otter, calm-fox and others";
  model.inputs.front().label = "Lubrication after velvet-otter";
  model.accepted_holes = {"depth 125 to 138 mm", "velvet-otter: depth 5 to 6 mm"};
  model.provenance = fuzzy::Provenance{
      "velvet-otter's study",
      {{"alpha", "0.95"},
       {"forms", R"({ "velvet-otter": "a2", "calm-fox": "a2", "S4": ["a2", "b"] })"},
       {"inferred", R"(["velvet-otter", "S4"])"}},
      {{"participants", "4"}, {"simulated", R"(["velvet-otter", "calm-fox"])"}, {"velvet-otter.csv", "12"}},
      "Simulated, not measured: strokes of velvet-otter, calm-fox, S4."};
  model.extra = {{"mine", R"({"who": {"deep": ["about velvet-otter", 1.50]}})"}, {"velvet-otter", "true"}};
  for (const double depth : {10.0, 60.0, 130.0}) {
    fuzzy::Check check;
    check.in = {0.1, 20, depth, 80};
    const auto now = fuzzy::compile(model)->evaluate(check.in);
    check.force = now.force_n;
    check.fired = now.fired;
    model.checks.push_back(check);
  }
  return model;
}

TEST(ExpertRemoval, NothingOfTheExpertIsLeftAndTheRestIsAModel) {
  const ForceModel before = study();
  const std::string text = formatModel(before);
  ASSERT_TRUE(parseModel(text, "before")) << parseModel(text, "before").error().message();
  const auto removal = withoutExperts(text, Names{"velvet-otter"});
  EXPECT_TRUE(removal.changed);
  EXPECT_EQ(removal.labels, std::vector<std::string>{"velvet-otter (simulated)"});
  EXPECT_EQ(removal.text.find("velvet"), std::string::npos) << removal.text;
  EXPECT_EQ(removal.text.find("0.123456"), std::string::npos);  // the weight of a rule of this expert only

  const auto after = parseModel(removal.text, "after");  // its checks are evaluated again here
  ASSERT_TRUE(after) << after.error().message();
  ASSERT_EQ(after->model.experts.size(), 3U);
  EXPECT_EQ(after->model.experts[1], before.experts[2]);
  EXPECT_EQ(after->model.experts[2], before.experts[3]);
  EXPECT_EQ(after->model.experts[0].rules, before.experts[1].rules);
  EXPECT_EQ(after->model.checks.size(), before.checks.size());
  EXPECT_EQ(after->model.accepted_holes, std::vector<std::string>{"depth 125 to 138 mm"});
  const auto& from = *after->model.provenance;
  EXPECT_EQ(from.notes,
            "Simulated, not measured: strokes of (withdrawn), calm-fox, S4."
            " Experts who withdrew were removed from this model.");
  EXPECT_EQ(from.settings[1].json, R"({ "calm-fox": "a2", "S4": ["a2", "b"] })");
  EXPECT_EQ(from.settings[2].json, R"(["S4"])");
  ASSERT_EQ(from.sources.size(), 2U);
  EXPECT_EQ(from.sources[1].json, R"(["calm-fox"])");
  ASSERT_EQ(after->model.extra.size(), 1U);
}

TEST(ExpertRemoval, TheOrderDoesNotMatterAndTwiceIsOnce) {
  const std::string text = formatModel(study());
  Names all = {"velvet-otter", "calm-fox", "S4"};
  const std::string at_once = withoutExperts(text, all).text;
  EXPECT_EQ(expertIds(at_once), std::vector<std::string>{"calm-fox-2"});
  std::sort(all.begin(), all.end());
  do {
    std::string one_by_one = text;
    for (const auto& name : all) {
      one_by_one = withoutExperts(one_by_one, Names{name}).text;
      EXPECT_FALSE(withoutExperts(one_by_one, Names{name}).changed);
    }
    EXPECT_EQ(one_by_one, at_once);
  } while (std::next_permutation(all.begin(), all.end()));
}

TEST(ExpertRemoval, ATextThatNamesNobodyStaysByteForByte) {
  for (const std::string& text : {formatModel(study()) + "\n ", std::string("no model"), std::string()}) {
    for (const char* name : {"misty-lake", "calm", "S", "N"}) {
      const auto removal = withoutExperts(text, Names{name});
      EXPECT_FALSE(removal.changed) << name;
      EXPECT_EQ(removal.text, text);
    }
  }
}

TEST(ExpertRemoval, WithoutAnyExpertTheTextSaysSo) {
  const std::string text = formatModel(study());
  const auto removal = withoutExperts(text, Names{"velvet-otter", "calm-fox", "calm-fox-2", "S4"});
  EXPECT_TRUE(removal.changed);
  EXPECT_LT(removal.text.size(), 200U);
  const auto read = parseModel(removal.text, "version");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message(),
            "version: found a model whose experts withdrew, so that nothing of it is left, wanted a model with one "
            "expert or more");
  EXPECT_FALSE(withoutExperts(removal.text, Names{"velvet-otter"}).changed);
}

TEST(ExpertRemoval, WeightsThatAreAllZeroBecomeOne) {
  ForceModel model = study();
  model.checks.clear();
  for (auto& expert : model.experts) expert.weight = expert.id == "S4" ? 1 : 0;
  const auto after = parseModel(withoutExperts(formatModel(model), Names{"S4"}).text, "after");
  ASSERT_TRUE(after) << after.error().message();
  for (const auto& expert : after->model.experts) EXPECT_EQ(expert.weight, 1) << expert.id;
}

TEST(ExpertRemoval, WhatCannotBeTakenApartIsReplacedWhole) {
  const Names names = {"velvet-otter"};
  // A damaged text, a name in JSON's escapes, a newer version, an id of a term.
  EXPECT_TRUE(withoutExperts(R"({"experts": [{"id": "velvet-otter")", names).changed);
  EXPECT_TRUE(withoutExperts(R"({"version": 9, "experts": [{"id": "v\u0065lvet-otter"}]})", names).changed);
  ForceModel model = study();
  model.inputs[0].terms[0].id = "poor for calm-fox-2";
  for (auto& expert : model.experts) {
    for (auto& rule : expert.rules) {
      for (auto& condition : rule.conditions) {
        if (condition.input == model.inputs[0].id && condition.term == "poor") condition.term = "poor for calm-fox-2";
      }
    }
  }
  model.checks.clear();
  const std::string text = formatModel(model);
  ASSERT_TRUE(parseModel(text, "before")) << parseModel(text, "before").error().message();
  const auto removal = withoutExperts(text, Names{"calm-fox-2"});
  EXPECT_TRUE(removal.changed);
  EXPECT_EQ(removal.text.find("calm-fox-2"), std::string::npos);
}

TEST(ExpertRemoval, RandomSubsetsInRandomOrderGiveTheSameBytes) {
  base::Random random(20261122);
  for (int round = 0; round < 30; ++round) {
    ForceModel model = study();
    model.checks.clear();
    for (auto& expert : model.experts) expert.weight = random.below(3);
    if (std::all_of(model.experts.begin(), model.experts.end(), [](const Expert& e) { return e.weight == 0; }))
      continue;
    const std::string text = formatModel(model);
    Names names;
    for (const auto& expert : model.experts) {
      if (random.below(2) == 0) names.push_back(expert.id);
    }
    const std::string at_once = withoutExperts(text, names).text;
    std::string one_by_one = text;
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
      one_by_one = withoutExperts(one_by_one, Names{*name}).text;
    }
    EXPECT_EQ(one_by_one, at_once);
  }
}

TEST(ExpertRemoval, IdsAreReadFromTextsThatAreNoModelsToo) {
  EXPECT_EQ(expertIds(formatModel(study())),
            (std::vector<std::string>{"velvet-otter", "calm-fox", "calm-fox-2", "S4"}));
  EXPECT_EQ(expertIds(R"({"experts": [{"id": "a"}, 5, {"id": 6}, {"id": "\u0062"}]})"),
            (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(expertIds("{").empty());
  EXPECT_TRUE(expertIds(R"({"experts": {}})").empty());
}

}  // namespace
}  // namespace tactus::model_io
