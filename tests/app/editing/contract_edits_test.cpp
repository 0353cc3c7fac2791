#include <gtest/gtest.h>

#include "app/editing/edit_history.h"
#include "app/editing/edit_impact.h"
#include "app/editing/rule_edits.h"
#include "core/contracts/contract_check.h"
#include "core/model_io/model_file.h"

#include "tests/support/ngt_model.h"

namespace tactus::editing {
namespace {

fuzzy::Contract contract(const fuzzy::ForceModel& model, const char* sentence) {
  return contracts::parseContract(model, sentence).value();
}

constexpr const char* kLubrication = "more lubrication never raises the force";
constexpr const char* kMost = "the force is never above 1 N";

TEST(ContractEdits, AddChangeAndRemoveAreOneEntryEach) {
  const auto start = support::s4FiveRegions();
  auto history = EditHistory::open(start, "start", {}, study::RecordIds(1)).value();
  ASSERT_TRUE(history.apply(addContract(history.model(), contract(start, kLubrication)).value(), {}));
  ASSERT_TRUE(history.apply(addContract(history.model(), contract(start, kMost)).value(), {}));
  EXPECT_EQ(history.labelOf(history.current()), std::string("Contract added: ") + kMost);
  const fuzzy::ForceModel two = history.model();
  ASSERT_EQ(two.contracts.size(), 2U);
  EXPECT_EQ(two.contracts[0].id, "never_raises");

  ASSERT_TRUE(history.apply(replaceContract(two, 1, contract(start, "the force is never above 0.9 N")).value(), {}));
  EXPECT_EQ(history.model().contracts[1].id, two.contracts[1].id) << "the same contract with another limit";
  EXPECT_EQ(history.model().contracts[1].limit, 0.9);
  ASSERT_TRUE(history.apply(removeContract(history.model(), 0).value(), {}));
  ASSERT_EQ(history.model().contracts.size(), 1U);
  EXPECT_EQ(history.model().contracts[0].limit, 0.9);
  EXPECT_EQ(history.states().size(), 5U);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(history.undo({}));
  EXPECT_EQ(history.model(), two);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(history.undo({}));
  EXPECT_TRUE(sameBits(history.model(), start));
}

TEST(ContractEdits, ChangeNoForceAndComeBackFromTheFile) {
  const auto start = support::s4FiveRegions();
  const auto edit = addContract(start, contract(start, kLubrication)).value();
  const auto impact = editImpact(start, *fuzzy::compile(start), edit.model, edit.compiled);
  EXPECT_EQ(impact.largest_n, 0);
  const auto text = model_io::modelText(edit.model, "contracts.tactus.json");
  ASSERT_TRUE(text);
  const auto read = model_io::parseModel(*text, "contracts.tactus.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->model.contracts, edit.model.contracts);
}

TEST(ContractEdits, RefuseTheSameSentenceTwiceAndNumbersThatMeanNothing) {
  const auto start = support::s4FiveRegions();
  const auto one = addContract(start, contract(start, kMost)).value().model;
  EXPECT_FALSE(addContract(one, contract(start, kMost)));
  auto two = addContract(one, contract(start, kLubrication)).value().model;
  EXPECT_FALSE(replaceContract(two, 1, contract(start, kMost)));
  EXPECT_TRUE(replaceContract(two, 0, contract(start, kMost))) << "itself";
  EXPECT_FALSE(replaceContract(two, 2, contract(start, kMost)));
  EXPECT_FALSE(removeContract(two, 2));
  auto step = contract(start, "the force never changes by more than 1 JND within 1 mm of depth");
  step.within = 0;
  EXPECT_FALSE(addContract(start, step));
}

TEST(ContractEdits, EachHasAnIdOfItsOwnAndNoMoreThanTheModelTakes) {
  auto model = support::s4FiveRegions();
  for (std::size_t i = 0; i < fuzzy::kMostContracts; ++i) {
    auto limit = contract(model, kMost);
    limit.limit = 1 + static_cast<double>(i);
    auto edit = addContract(model, limit);
    ASSERT_TRUE(edit) << i;
    model = std::move(edit->model);
  }
  EXPECT_EQ(model.contracts[1].id, "never_above 2");
  auto limit = contract(model, kMost);
  limit.limit = 0.5;
  EXPECT_FALSE(addContract(model, limit));
}

}  // namespace
}  // namespace tactus::editing
