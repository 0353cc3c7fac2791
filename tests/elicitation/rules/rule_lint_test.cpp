#include "elicitation/rules/rule_lint.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "elicitation/force/noticeable_force.h"
#include "elicitation/model/model_builder.h"

#include "tests/elicitation/small_study.h"
#include "tests/support/day.h"

namespace tactus::elicitation {
namespace {

using Kind = RuleFinding::Kind;
using Status = study::Answer::Status;

/// A study with its model and what the lint says of it.
struct Linted {
  study::Study study;
  BuiltModel built;
  fuzzy::CompiledModel compiled;
  RuleLint lint;

  explicit Linted(study::Study from, const RuleLintSettings& settings = {})
      : study(std::move(from)),
        built(buildModel(study, std::vector{form45()}, {}).value()),
        compiled(fuzzy::compile(built.model).value()),
        lint(ruleLint(built.model, compiled, built.experts, settings)) {}

  std::vector<RuleFinding> of(Kind kind) const {
    std::vector<RuleFinding> out;
    for (const auto& finding : lint.findings) {
      if (finding.kind == kind) out.push_back(finding);
    }
    return out;
  }
  std::size_t expert(const std::string& id) const {
    for (std::size_t e = 0; e < built.model.experts.size(); ++e) {
      if (built.model.experts[e].id == id) return e;
    }
    return built.model.experts.size();
  }
  double force(const std::string& id, const std::vector<double>& at) const {
    return compiled.evaluateExpert(expert(id), at).force_n;
  }
  double mean(const std::vector<double>& at) const { return compiled.evaluate(at).force_n; }
};

/// Two experts who say `medium` everywhere.
study::Study twoAlike() {
  study::Study study;
  answerAll(study, "A", "medium");
  answerAll(study, "B", "medium", 47);
  return study;
}

void leaveOut(study::Study& study, const std::string& who, int item, Status status) {
  auto& answer = answerOf(study, who, item);
  answer.status = status;
  answer.term.clear();
}

/// Largest minus smallest force of `expert` at `at` over all answers to an item, from models with that answer added.
double spreadOverAnswers(const Linted& linted, std::size_t expert, const std::vector<fuzzy::Condition>& conditions,
                         const std::vector<double>& at) {
  double low = 1e9;
  double high = -1e9;
  for (const auto& term : forceTermIds()) {
    auto model = linted.built.model;
    model.experts[expert].rules.push_back({conditions, term, 1, true});
    const auto force = fuzzy::compile(model).value().evaluateExpert(expert, at);
    EXPECT_TRUE(force.fired);
    low = std::min(low, force.force_n);
    high = std::max(high, force.force_n);
  }
  return high - low;
}

TEST(RuleLint, NothingToSayOfTwoWhoAgreeEverywhere) {
  const Linted linted(twoAlike());
  // Only that four of the five words are never used, once for each expert.
  for (const auto& finding : linted.lint.findings) EXPECT_EQ(finding.kind, Kind::kUnreachableTerm) << finding.text;
  EXPECT_EQ(linted.lint.findings.size(), 8U);
}

TEST(RuleLint, AMissingItemNamesExpertItemLineAndReason) {
  auto study = twoAlike();
  leaveOut(study, "A", 3, Status::kCantTell);
  leaveOut(study, "A", 4, Status::kSkipped);
  leaveOut(study, "B", 45, Status::kCleared);
  std::erase_if(study.answers, [](const auto& answer) { return answer.participant == "B" && answer.item == 44; });
  const Linted linted(std::move(study));
  EXPECT_EQ(linted.built.model.experts[0].rules.size(), 43U);
  const auto missing = linted.of(Kind::kMissingItem);
  ASSERT_EQ(missing.size(), 4U);
  const auto text = [&](const std::string& who, int item) {
    for (const auto& one : missing) {
      if (one.experts.front() == who && one.sources.front().origin.item == item) return one.text;
    }
    return std::string("none");
  };
  EXPECT_EQ(text("A", 3),
            "no rule for depth is oropharynx and lubrication is poor: item 3 (answers.csv, line 4), cannot tell");
  EXPECT_EQ(text("A", 4),
            "no rule for depth is laryngopharynx and lubrication is poor: item 4 (answers.csv, line 5), skipped");
  EXPECT_EQ(text("B", 45), "no rule for depth is esophagus and speed is fast: item 45 (answers.csv, line 91), cleared");
  EXPECT_EQ(text("B", 44), "no rule for depth is laryngopharynx and speed is fast: item 44, no answer");
  // The other rules of the region still fire there, so nothing is a hole.
  EXPECT_TRUE(linted.of(Kind::kHole).empty());
  // Without them the answer would decide alone: very small is the centroid of (0, 0, .2, .3), very large that of
  // (.7, .8, 1.1, 1.1); with `medium` beside them the spread is smaller.
  const double very_small = (0.02 + 0.05 * (0.2 + 0.1 / 3)) / 0.25;
  const double very_large = (0.05 * (0.7 + 0.2 / 3) + 0.3 * 0.95) / 0.35;
  for (const auto& one : missing) {
    EXPECT_GT(*one.newtons, 0);
    EXPECT_LT(*one.newtons, very_large - very_small);
    EXPECT_TRUE(one.at_least);
  }
}

TEST(RuleLint, ARegionWithoutAnyAnswerIsNamedWithItsItemsAndTheJumpOfTheMean) {
  auto study = twoAlike();
  for (auto& answer : study.answers) {
    if (answer.participant == "B" && answer.item % 5 == 0) leaveOut(study, "B", answer.item, Status::kSkipped);
    if (answer.participant == "B" && answer.item % 5 != 0) answer.term = "large";
  }
  const Linted linted(std::move(study));
  const auto regions = linted.of(Kind::kRegionWithoutRule);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].experts, std::vector<std::string>{"B"});
  EXPECT_EQ(regions[0].sources.size(), 9U);
  EXPECT_EQ(regions[0].text,
            "no rule in the esophagus; no answer to items 5, 10, 15, 20, 25, 30, 35, 40, 45 (answers.csv, lines 51, "
            "56, 61, 66, 71, 76, 81, 86, 91)");
  // The esophagus begins at 185 mm; the laryngopharynx, the last with rules of B, ends at 215 mm.
  const auto holes = linted.of(Kind::kHole);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_EQ(holes[0].place, "depth 215 to 600 mm");
  EXPECT_EQ(holes[0].sources.size(), 9U);
  EXPECT_NE(holes[0].text.find("no answer to items 5, 10"), std::string::npos) << holes[0].text;
  // A says .55 N (symmetric), B .7 N (symmetric): the mean falls from .625 N to .55 N.
  const auto jumps = linted.of(Kind::kAbstentionJump);
  ASSERT_EQ(jumps.size(), 1U);
  EXPECT_NEAR(*jumps[0].newtons, 0.075, 1e-12);
  EXPECT_NE(jumps[0].text.find("with this expert 0.625 N, without 0.550 N"), std::string::npos) << jumps[0].text;
  EXPECT_NEAR(jumps[0].from[2], 215, 1e-9);
  EXPECT_NEAR(jumps[0].to[2], 215, 1e-9);
  EXPECT_LT(jumps[0].from[2], jumps[0].to[2]);
  EXPECT_NEAR(*regions[0].newtons, 0.7, 1e-12) << "the jump of B's own force to the default force 0";
}

TEST(RuleLint, AStepAgainstTheDeclarationNamesBothItems) {
  auto study = twoAlike();
  answerOf(study, "A", 14).term = "large";  // well lubricated, laryngopharynx: more than medium lubrication (item 9)
  const Linted linted(study);
  auto against = linted.of(Kind::kAgainstDeclaration);
  ASSERT_EQ(against.size(), 1U);
  EXPECT_EQ(against[0].text,
            "against the declared direction: lubrication from medium to well where depth is laryngopharynx, force from "
            "medium to large; items 9, 14 (answers.csv, lines 10, 15)");
  EXPECT_EQ(against[0].sources[0].origin.item, 9);
  EXPECT_EQ(against[0].sources[1].origin.item, 14);
  EXPECT_EQ(against[0].from[0], 0.5) << "the middle of the core of medium";
  EXPECT_EQ(against[0].to[0], 0.9);
  EXPECT_GT(*against[0].newtons, 0);

  // It is a declaration, not a law.
  RuleLintSettings settings;
  settings.directions = {{"lubrication", analysis::Direction::kRises}};
  EXPECT_TRUE(Linted(study, settings).of(Kind::kAgainstDeclaration).empty());
  settings.directions = std::vector<DeclaredDirection>{};
  const Linted undeclared(study, settings);
  EXPECT_TRUE(undeclared.of(Kind::kAgainstDeclaration).empty());
}

TEST(RuleLint, AFlexedNeckThatRaisesTheForceIsAgainstTheDeclarationOfTheStudy) {
  auto study = twoAlike();
  answerOf(study, "A", 30).term = "very_large";  // large flexion, esophagus
  const auto against = Linted(std::move(study)).of(Kind::kAgainstDeclaration);
  ASSERT_EQ(against.size(), 1U);
  EXPECT_EQ(against[0].place,
            "neck_flexion from medium to large where depth is esophagus, force from medium to very_large");
}

TEST(RuleLint, AStepIsToldOnceWhereItIsAgainstTheDeclarationAndTheExpertsOwnDirection) {
  auto study = twoAlike();
  // A: speed raises the force in four regions and lowers it in the esophagus.
  for (int region = 1; region <= 5; ++region) {
    answerOf(study, "A", 30 + region).term = region == 5 ? "large" : "small";
    answerOf(study, "A", 40 + region).term = region == 5 ? "medium" : "large";
  }
  const Linted linted(std::move(study));
  EXPECT_EQ(linted.of(Kind::kAgainstDeclaration).size(), 1U);
  EXPECT_TRUE(linted.of(Kind::kDirectionChange).empty());
}

TEST(RuleLint, JumpsOfThreeLevelsBetweenNeighboringAnswers) {
  auto study = twoAlike();
  answerOf(study, "A", 31).term = "very_small";  // slow, nasal cavity
  answerOf(study, "A", 36).term = "large";       // medium speed there: three levels up
  answerOf(study, "A", 41).term = "very_large";
  const auto jumps = Linted(study).of(Kind::kLevelJump);
  ASSERT_EQ(jumps.size(), 1U);
  EXPECT_EQ(jumps[0].text,
            "3 levels at once: speed from slow to medium where depth is nasal_cavity, force from very_small to large; "
            "items 31, 36 (answers.csv, lines 32, 37)");
  // Two levels: also from either of the outer ones to `medium` in the nasopharynx.
  RuleLintSettings settings;
  settings.jump_levels = 2;
  EXPECT_EQ(Linted(study, settings).of(Kind::kLevelJump).size(), 3U);
  // Without the answer between, slow and fast are no neighbors.
  leaveOut(study, "A", 36, Status::kSkipped);
  EXPECT_TRUE(Linted(study).of(Kind::kLevelJump).empty());
}

TEST(RuleLint, ExpertsFarApartAreNamedByRegion) {
  study::Study study;
  answerAll(study, "A", "small");
  answerAll(study, "B", "large");
  for (int item = 1; item <= 45; ++item) {
    if (item % 5 != 3) answerOf(study, "B", item).term = "small";  // apart in the oropharynx alone
  }
  const Linted linted(std::move(study));
  const auto apart = linted.of(Kind::kExpertsApart);
  ASSERT_FALSE(apart.empty());
  EXPECT_EQ(apart[0].place, "depth is oropharynx");
  EXPECT_EQ(apart[0].experts, (std::vector<std::string>{"A", "B"}));
  // Both are symmetric: .35 N and .7 N, whatever the strength.
  EXPECT_NEAR(*apart[0].newtons, 0.35, 1e-12);
  EXPECT_NE(apart[0].text.find("no expert's force is near their mean of 0.525 N"), std::string::npos) << apart[0].text;
  EXPECT_EQ(apart[0].from, apart[0].to);
  // Every item about the oropharynx has a number that ends in 3 or 8.
  ASSERT_EQ(apart[0].sources.size(), 2U);
  for (const auto& source : apart[0].sources) EXPECT_EQ(source.origin.item % 5, 3);
  for (const auto& finding : apart) {
    EXPECT_GT(*finding.newtons, 2 * justNoticeableDifference(linted.mean(finding.from)));
  }
}

TEST(RuleLint, ForcesInAnotherUnitAreNotComparedByFeel) {
  study::Study study;
  answerAll(study, "A", "very_small");
  answerAll(study, "B", "very_large");
  auto model = Linted(study).built.model;
  model.output.unit = "mN";
  const auto lint = ruleLint(model, fuzzy::compile(model).value());
  for (const auto& finding : lint.findings) EXPECT_NE(finding.kind, Kind::kExpertsApart);
}

TEST(RuleLint, WithoutTheStudyRulesAreNamedByTheirNumber) {
  auto study = twoAlike();
  answerOf(study, "A", 30).term = "very_large";
  const Linted linted(std::move(study));
  const auto lint = ruleLint(linted.built.model, linted.compiled);
  const auto against = std::find_if(lint.findings.begin(), lint.findings.end(),
                                    [](const RuleFinding& f) { return f.kind == Kind::kAgainstDeclaration; });
  ASSERT_NE(against, lint.findings.end());
  EXPECT_NE(against->text.find("; rules 25, 30"), std::string::npos) << against->text;
}

TEST(RuleLint, AConflictOfGivenRulesNamesTheirLines) {
  study::Study study;
  study::Participant participant;
  participant.code = "A";
  study.participants = {participant};
  study.rules = {{"A", "", {{"speed", "slow"}, {"depth", "stomach"}}, "small", 1, {2}},
                 {"A", "", {{"depth", "stomach"}, {"speed", "slow"}}, "large", 1, {5}}};
  const Linted linted(std::move(study));
  const auto conflicts = linted.of(Kind::kConflict);
  ASSERT_EQ(conflicts.size(), 1U);
  EXPECT_EQ(conflicts[0].text,
            "two rules for depth is stomach and speed is slow: small and large; rules 1, 2 (rules.csv, lines 2, 5)");
  EXPECT_NEAR(*conflicts[0].newtons, 0.35, 1e-12);  // .7 N and .35 N, each symmetric
  EXPECT_FALSE(conflicts[0].at_least);
  EXPECT_TRUE(linted.of(Kind::kMissingItem).empty()) << "given rules have no items";
}

// Every number a finding gives is what evaluation gives at the points it names.
void expectDirectEvaluation(const Linted& linted, const RuleFinding& finding) {
  constexpr double kRounding = 1e-12;  // a few operations on forces of about 1 N
  if (!finding.newtons || finding.from.empty()) return;
  const auto& from = finding.from;
  const auto& to = finding.to;
  const std::string who = finding.experts.empty() ? "" : finding.experts.front();
  const auto own = [&](const std::vector<double>& at) { return who.empty() ? linted.mean(at) : linted.force(who, at); };
  const double to_default = std::abs(own(from) - linted.built.model.default_force_n);
  const double of_mean = std::abs(linted.mean(from) - linted.mean(to));
  switch (finding.kind) {
    case Kind::kHole: EXPECT_NEAR(*finding.newtons, to_default, kRounding) << finding.text; break;
    case Kind::kAbstentionJump: EXPECT_NEAR(*finding.newtons, of_mean, kRounding) << finding.text; break;
    case Kind::kRegionWithoutRule:
      EXPECT_TRUE(std::abs(*finding.newtons - to_default) < kRounding ||
                  std::abs(*finding.newtons - of_mean) < kRounding);
      break;
    case Kind::kAgainstDeclaration:
    case Kind::kLevelJump:
    case Kind::kDirectionChange:
      EXPECT_NEAR(*finding.newtons, std::abs(own(to) - own(from)), kRounding) << finding.text;
      break;
    case Kind::kExpertsApart:
      EXPECT_NEAR(*finding.newtons, linted.force(finding.experts.at(1), from) - own(from), kRounding) << finding.text;
      break;
    case Kind::kMissingItem: {
      const auto item = static_cast<std::size_t>(finding.sources.front().origin.item);
      std::vector<fuzzy::Condition> conditions;
      const auto form = form45();
      for (const auto& condition : form.items[item - 1].conditions) {
        conditions.push_back({condition.input, condition.term});
      }
      EXPECT_NEAR(*finding.newtons, spreadOverAnswers(linted, linted.expert(who), conditions, from), kRounding);
      break;
    }
    default: break;
  }
}

TEST(RuleLint, OnRandomStudies) {
  for (int run = 0; run < support::rounds(50); ++run) {
    const std::uint64_t seed = support::firstSeedOfToday() + static_cast<std::uint64_t>(run);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Linted linted(randomStudy(seed));
    std::size_t answered = 0;
    for (const auto& answer : linted.study.answers) answered += answer.status == Status::kAnswered ? 1 : 0;
    std::size_t rules = 0;
    for (std::size_t e = 0; e < linted.built.experts.size(); ++e) {
      const auto& expert = linted.built.experts[e];
      rules += expert.rules.size();
      EXPECT_EQ(expert.origins.size(), expert.rules.size());
      EXPECT_EQ(expert.rules.size() + expert.missing.size(), 45U);
    }
    EXPECT_EQ(rules, answered);
    EXPECT_EQ(linted.of(Kind::kMissingItem).size(), 45 * linted.built.experts.size() - answered);

    const double range = linted.built.model.output.max - linted.built.model.output.min;
    for (const auto& finding : linted.lint.findings) {
      EXPECT_FALSE(finding.text.empty());
      if (finding.newtons) {
        EXPECT_GE(*finding.newtons, 0);
        EXPECT_LE(*finding.newtons, finding.kind == Kind::kDisagreement ? 2 * range : range) << finding.text;
      }
      expectDirectEvaluation(linted, finding);
    }
    // By kind, then the largest first.
    EXPECT_TRUE(
        std::is_sorted(linted.lint.findings.begin(), linted.lint.findings.end(), [](const auto& x, const auto& y) {
          return std::pair{x.kind, -x.newtons.value_or(-1)} < std::pair{y.kind, -y.newtons.value_or(-1)};
        }));
  }
}

TEST(RuleLint, EveryHoleOfAnExpertIsAMissingItem) {
  for (std::uint64_t seed = 100; seed <= 120; ++seed) {
    const Linted linted(randomStudy(seed));
    for (const auto& hole : linted.of(Kind::kHole)) {
      if (hole.experts.empty()) continue;
      EXPECT_FALSE(hole.sources.empty()) << "seed " << seed << ": " << hole.text;
    }
  }
}

TEST(RuleLint, EndsWithoutALookAtTheForcesOnceItIsToldToStop) {
  const Linted linted(twoAlike());
  std::stop_source stop;
  stop.request_stop();
  const auto lint = ruleLint(linted.built.model, linted.compiled, {}, {}, stop.get_token());
  EXPECT_EQ(lint.model.reachable.points, 0U);
  EXPECT_FALSE(lint.newtons_complete);
  EXPECT_GT(linted.lint.model.reachable.points, 0U);
}

}  // namespace
}  // namespace tactus::elicitation
