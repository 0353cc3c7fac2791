// Sentences of contracts, written and read by one grammar.
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/contracts/contract_check.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::contracts {
namespace {

using Kind = fuzzy::Contract::Kind;

TEST(ContractText, SentencesOfTheNgtModel) {
  const auto model = support::s4FiveRegions();
  for (const char* const sentence :
       {"more lubrication never raises the force", "more neck flexion never lowers the force",
        "depth in nasal cavity is never harder than in laryngopharynx",
        "the force never changes by more than 1 JND within 1 mm of depth",
        "the force never changes by more than 0.05 N within 4 mm/s of speed",
        "the force never changes by more than 0.05 N within 0.1 of lubrication",
        "the force is never above 1 N where depth is esophagus and speed is fast", "the force is never below 0.1 N",
        "the model is never silent", "more speed never lowers the force where lubrication is well"}) {
    const auto contract = parseContract(model, sentence);
    ASSERT_TRUE(contract.has_value()) << contract.error().message();
    EXPECT_EQ(sentenceOf(model, *contract), sentence);
  }
  const auto typed = parseContract(model, "  More LUBRICATION never raises  the force where depth is nasal cavity. ");
  ASSERT_TRUE(typed.has_value()) << typed.error().message();
  EXPECT_EQ(typed->kind, Kind::kNeverRaises);
  EXPECT_EQ(typed->where, (std::vector<fuzzy::Condition>{{"depth", "nasal_cavity"}}));
}

TEST(ContractText, Refusals) {
  const auto model = support::s4FiveRegions();
  for (const auto& [sentence, says] :
       {std::pair{"more grease never raises the force", "lubrication, neck flexion, depth, speed"},
        {"more lubrication raises the force", "'never raises the force'"},
        {"depth in stomach is never harder than in liver", "a word: nasal cavity"},
        {"the force is never above much", "a force"},
        {"the force is never above 1 N where speed is slow and speed is fast", "each input once"},
        {"the force is never above 1 N please", "'where' or the end"},
        {"the force never changes by more than 0 N within 1 mm of depth", "above 0"},
        {"", "found the end of the sentence"}}) {
    const auto contract = parseContract(model, sentence);
    ASSERT_FALSE(contract.has_value()) << sentence;
    EXPECT_NE(contract.error().message().find(says), std::string::npos) << contract.error().message();
  }
}

/// Names that look like words of the grammar, or like each other.
fuzzy::ForceModel oddNames(fuzzy::ForceModel model, base::Random& random) {
  constexpr const char* kNames[] = {"more",  "in",   "a_b", "a b", "A_B", "wo\"rd\\", "x is y", "the_force",
                                    "Tiefe", "深さ", "_x",  "x_",  "1",   "and",      "where",  "depth_1"};
  const auto start = static_cast<std::size_t>(random.below(16));
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    model.inputs[i].id = kNames[(start + i) % 16];
    for (std::size_t t = 0; t < model.inputs[i].terms.size(); ++t)
      model.inputs[i].terms[t].id = kNames[(start + i + 3 * t) % 16];
  }
  return model;
}

TEST(ContractText, AnyContractReadsBack) {
  base::Random random(9);
  for (int round = 0; round < 400; ++round) {
    const auto model = oddNames(support::randomModel(random), random);
    const auto& input = model.inputs[static_cast<std::size_t>(random.below(static_cast<int>(model.inputs.size())))];
    fuzzy::Contract contract;
    contract.kind = fuzzy::kContractKinds[static_cast<std::size_t>(random.below(7))];
    const bool about_input = contract.kind == Kind::kNeverRaises || contract.kind == Kind::kNeverLowers ||
                             contract.kind == Kind::kNeverHarder || contract.kind == Kind::kNoStep;
    if (about_input) contract.input = input.id;
    if (contract.kind == Kind::kNeverHarder) {
      contract.word = input.terms.front().id;
      contract.than = input.terms.back().id;
    }
    if (contract.kind == Kind::kNoStep)
      contract.within = random.uniform(), contract.limit_in_jnd = random.below(2) == 0;
    if (contract.kind == Kind::kNoStep || contract.kind == Kind::kNeverAbove || contract.kind == Kind::kNeverBelow)
      contract.limit = random.uniform();
    if (random.below(2) == 0) contract.where.push_back({input.id, input.terms.back().id});
    const std::string sentence = sentenceOf(model, contract);
    const auto read = parseContract(model, sentence);
    ASSERT_TRUE(read.has_value()) << sentence << ": " << read.error().message();
    EXPECT_EQ(*read, contract) << sentence;
  }
}

}  // namespace
}  // namespace tactus::contracts
