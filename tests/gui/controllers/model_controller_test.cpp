#include "app/workbench/controllers/model_controller.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

TEST(ModelController, OpensAGoodFile) {
  const tests::ModelFolder folder;
  ModelController models;
  const QSignalSpy opened(&models, &ModelController::opened);
  models.open(folder.write(tests::twoExperts()));
  ASSERT_EQ(opened.count(), 1);
  EXPECT_EQ(models.current()->model.name, "Two experts");
  EXPECT_EQ(models.current()->compiled.expertCount(), 2U);
  EXPECT_FALSE(models.current()->simulated);
}

TEST(ModelController, ABrokenFileLeavesTheOldModel) {
  const tests::ModelFolder folder;
  ModelController models;
  models.open(folder.write(tests::twoExperts()));
  const QSignalSpy failed(&models, &ModelController::openFailed);
  models.open(folder.writeText("{\"format\": \"tactus-force-model\", ", QStringLiteral("cut.json")));
  ASSERT_EQ(failed.count(), 1);
  const QString sentence = failed[0][1].toString();
  EXPECT_TRUE(sentence.contains(QStringLiteral("cut.json"))) << sentence.toStdString();
  EXPECT_FALSE(sentence.contains(QLatin1Char('\n')));
  EXPECT_EQ(models.current()->model.name, "Two experts");
}

TEST(ModelController, ReopenReadsTheFileAgain) {
  const tests::ModelFolder folder;
  ModelController models;
  models.reopen();
  EXPECT_EQ(models.current(), nullptr);
  fuzzy::ForceModel model = tests::twoExperts();
  models.open(folder.write(model));
  model.name = "Edited";
  folder.write(model);
  models.reopen();
  EXPECT_EQ(models.current()->model.name, "Edited");
}

TEST(SaysSimulated, FollowsProvenanceAndLabels) {
  fuzzy::ForceModel model = tests::twoExperts();
  EXPECT_FALSE(saysSimulated(model));
  model.provenance = fuzzy::Provenance{};
  model.provenance->sources = {{"participants", R"([{"participant": "S1", "simulated": false}])"}};
  EXPECT_FALSE(saysSimulated(model));
  model.provenance->sources = {{"participants", R"([{"participant": "S1", "simulated": true}])"}};
  EXPECT_TRUE(saysSimulated(model));
  model.provenance->sources = {{"answers", R"("simulated with seed 7")"}};
  EXPECT_TRUE(saysSimulated(model));
  model.provenance->sources = {{"simulated", "[]"}};
  EXPECT_FALSE(saysSimulated(model));
  model.provenance->sources = {{"simulated", R"(["S1"])"}};
  EXPECT_TRUE(saysSimulated(model));
  model.provenance->sources.clear();
  model.provenance->notes = "Simulated answers.";
  EXPECT_TRUE(saysSimulated(model));
  model.provenance.reset();
  model.experts[0].label = "A (simulated)";
  EXPECT_TRUE(saysSimulated(model));
}

}  // namespace
}  // namespace tactus::workbench
