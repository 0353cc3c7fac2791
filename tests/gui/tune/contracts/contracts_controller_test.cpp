#include "app/workbench/tune/contracts/contracts_controller.h"

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/editing/rule_edits.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

constexpr const char* kLubrication = "more lubrication never raises the force";
constexpr const char* kSilent = "the model is never silent";
constexpr const char* kMost = "the force is never above 1 N";
constexpr const char* kTooMuch = "the force is never above 0.5 N where speed is fast";

class ContractsControllerTest : public testing::Test {
 protected:
  void SetUp() override { open({}); }

  void open(std::initializer_list<const char*> sentences) {
    auto model = support::s4FiveRegions();
    for (const char* const sentence : sentences)
      model = editing::addContract(model, contracts::parseContract(model, sentence).value()).value().model;
    path = folder.write(model);
    models.open(path);
  }
  bool wait() {
    return QTest::qWaitFor([this] { return contracts.isCurrent() && !contracts.isBusy(); }, tests::kPatience);
  }
  const ShownContract& shown(std::size_t index) const { return contracts.shown()[index]; }

  tests::ModelFolder folder;
  QString path;
  ModelController models;
  SceneController scene{models};
  EditController edits{models};
  ContractsController contracts{edits, scene};
  QObject view;
};

// The command checks the same file: each verdict, excess and force is its own.
TEST_F(ContractsControllerTest, SaysWhatTheCommandSays) {
  open({kLubrication, kMost, kSilent, kTooMuch, "more speed never lowers the force",
        "depth in nasal cavity is never harder than in laryngopharynx"});
  contracts.hold(view);
  ASSERT_TRUE(wait());
  const cli::ProgramRun run({"check", path.toStdString(), "--json"});
  const auto json = nlohmann::json::parse(run.out)["contracts"];
  ASSERT_EQ(json.size(), contracts.shown().size());
  std::size_t broken = 0;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const ShownContract& one = shown(i);
    const std::string verdict = json[i]["verdict"];
    EXPECT_EQ(one.state, verdict == "proved"     ? ContractState::kProved
                         : verdict == "violated" ? ContractState::kBroken
                                                 : ContractState::kOpen)
        << json[i].dump();
    EXPECT_FALSE(one.old);
    if (verdict != "violated") continue;
    ++broken;
    const QString by = text(base::roundedNumber(json[i]["excess_n"].get<double>())) + QStringLiteral(" N");
    EXPECT_TRUE(one.details.contains(by)) << one.details.toStdString() << " " << by.toStdString();
    const auto& places = json[i]["counterexample"];
    ASSERT_EQ(places.size(), one.places.size());
    for (std::size_t p = 0; p < places.size(); ++p) {
      EXPECT_EQ(places[p]["in"].get<std::vector<double>>(), one.places[p]);
      EXPECT_TRUE(one.details.contains(forceText(places[p]["force"].get<double>(), "N")));
    }
  }
  EXPECT_GE(broken, 2U);
  EXPECT_EQ(contracts.count(ContractState::kBroken), broken);
}

TEST_F(ContractsControllerTest, ComputesOnlyWhileItIsSeen) {
  open({kLubrication});
  QTest::qWait(50);
  EXPECT_EQ(shown(0).state, ContractState::kComputing);
  EXPECT_FALSE(contracts.isBusy());
  contracts.hold(view);
  ASSERT_TRUE(wait());
  EXPECT_EQ(shown(0).state, ContractState::kBroken);
}

TEST_F(ContractsControllerTest, AnEditLeavesTheLastStateAsAnOldOneUntilItIsCheckedAnew) {
  open({kTooMuch});
  contracts.hold(view);
  ASSERT_TRUE(wait());
  ASSERT_EQ(shown(0).state, ContractState::kBroken);
  // Every rule says very small: then no force is above 0.5 N.
  const auto& rules = edits.model().experts[0].rules;
  std::vector<std::size_t> all(rules.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  ASSERT_TRUE(edits.apply(editing::setConsequent(edits.model(), edits.model().experts[0].id, all, "very_small")));
  EXPECT_EQ(shown(0).state, ContractState::kBroken);
  EXPECT_TRUE(shown(0).old);
  EXPECT_FALSE(contracts.isCurrent());
  EXPECT_EQ(stateText(shown(0).state, shown(0).old), QStringLiteral("was broken"));
  ASSERT_TRUE(wait());
  EXPECT_EQ(shown(0).state, ContractState::kProved);
  EXPECT_TRUE(shown(0).places.empty());
  edits.undo();
  ASSERT_TRUE(wait());
  EXPECT_EQ(shown(0).state, ContractState::kBroken);
}

TEST_F(ContractsControllerTest, AddChangeAndRemoveAreOneUndoStepEachInTheModelFile) {
  contracts.hold(view);
  const auto& model = edits.model();
  ASSERT_TRUE(contracts.add(contracts::parseContract(model, kMost).value()));
  ASSERT_TRUE(wait());
  EXPECT_EQ(shown(0).state, ContractState::kProved);
  ASSERT_TRUE(contracts.replace(0, contracts::parseContract(model, "the force is never above 0.2 N").value()));
  ASSERT_TRUE(wait());
  EXPECT_EQ(shown(0).state, ContractState::kBroken);
  models.save();
  const auto read = model_io::readModel(path.toStdString());
  ASSERT_TRUE(read);
  ASSERT_EQ(read->model.contracts.size(), 1U);
  EXPECT_EQ(read->model.contracts[0].limit, 0.2);
  ASSERT_TRUE(contracts.remove(0));
  EXPECT_TRUE(contracts.shown().empty());
  edits.undo();
  edits.undo();
  ASSERT_TRUE(wait());
  EXPECT_EQ(shown(0).state, ContractState::kProved);
  edits.undo();
  EXPECT_EQ(edits.model(), support::s4FiveRegions());
}

TEST_F(ContractsControllerTest, RefusesOneThatIsThere) {
  open({kMost});
  QSignalSpy refused(&edits, &EditController::refused);
  EXPECT_FALSE(contracts.add(contracts::parseContract(edits.model(), kMost).value()));
  EXPECT_EQ(refused.count(), 1);
  EXPECT_EQ(edits.model().contracts.size(), 1U);
}

TEST_F(ContractsControllerTest, OneClickGoesToTheCounterexampleAndTheNextToItsOtherPlace) {
  open({kLubrication});
  contracts.hold(view);
  ASSERT_TRUE(wait());
  QSignalSpy placed(&contracts, &ContractsController::placeShown);
  const auto places = shown(0).places;
  ASSERT_EQ(places.size(), 2U);
  ASSERT_EQ(shown(0).along, 0U) << "lubrication";
  contracts.feel(0, 0);
  EXPECT_EQ(scene.values(), places[0]);
  EXPECT_EQ(scene.xInput(), 0U);
  contracts.feel(0, 1);
  EXPECT_EQ(scene.values(), places[1]);
  EXPECT_EQ(placed.count(), 2);
  // What is felt there breaks it.
  const auto& compiled = models.current()->compiled;
  EXPECT_GT(compiled.evaluate(places[1]).force_n, compiled.evaluate(places[0]).force_n + 0.06);
  contracts.feel(0, 2);
  contracts.feel(7, 0);
  EXPECT_EQ(placed.count(), 2);
}

TEST_F(ContractsControllerTest, OffersWhatThePackDeclaresAndNotWhatIsThere) {
  const auto model = edits.model();
  const auto offered = offeredContracts(model);
  std::vector<std::string> sentences;
  for (const auto& one : offered) sentences.push_back(contracts::sentenceOf(model, one));
  const auto has = [&](const char* sentence) {
    return std::find(sentences.begin(), sentences.end(), sentence) != sentences.end();
  };
  EXPECT_TRUE(has(kLubrication));
  EXPECT_TRUE(has("more neck flexion never raises the force"));
  EXPECT_TRUE(has("more speed never lowers the force"));
  EXPECT_TRUE(has("the force never changes by more than 1 JND within 1 mm of depth"));
  EXPECT_TRUE(has(kMost));
  EXPECT_TRUE(has(kSilent));
  for (const auto& one : offered) EXPECT_TRUE(editing::addContract(model, one)) << contracts::sentenceOf(model, one);
  const auto with = editing::addContract(model, contracts::parseContract(model, kLubrication).value()).value().model;
  EXPECT_EQ(offeredContracts(with).size(), offered.size() - 1);
}

TEST_F(ContractsControllerTest, OfAModelWithoutTheNamesItSaysSoAndStaysOpen) {
  auto model = support::s4FiveRegions();
  fuzzy::Contract gone;
  gone.id = "gone";
  gone.kind = fuzzy::Contract::Kind::kNeverRaises;
  gone.input = "oil_film";
  model.contracts = {gone};
  models.open(folder.write(model, QStringLiteral("gone.tactus.json")));
  contracts.hold(view);
  ASSERT_TRUE(wait());
  EXPECT_EQ(shown(0).state, ContractState::kOpen);
  EXPECT_EQ(shown(0).sentence, QStringLiteral("More “oil film” never raises the force"));
  EXPECT_TRUE(shown(0).details.contains(QStringLiteral("oil_film")));
}

TEST_F(ContractsControllerTest, AHoleBreaksTheOneAboutSilence) {
  auto model = tests::twoExperts();
  model = editing::addContract(model, contracts::parseContract(model, kSilent).value()).value().model;
  models.open(folder.write(model, QStringLiteral("hole.tactus.json")));
  contracts.hold(view);
  ASSERT_TRUE(wait());
  EXPECT_EQ(shown(0).state, ContractState::kBroken);
  ASSERT_EQ(shown(0).places.size(), 1U);
  EXPECT_GE(shown(0).places[0][tests::kDepth], 5);
  EXPECT_LE(shown(0).places[0][tests::kDepth], 6);
  EXPECT_TRUE(shown(0).details.startsWith(QStringLiteral("No rule fires at ")));
}

}  // namespace
}  // namespace tactus::workbench
