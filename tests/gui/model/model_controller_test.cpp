#include "app/workbench/model/model_controller.h"

#include <QSignalSpy>
#include <array>
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

TEST(ModelController, AnEditKeepsThePathAndMarksTheModel) {
  const tests::ModelFolder folder;
  ModelController models;
  const QString path = folder.write(tests::twoExperts());
  models.open(path);
  const auto before = models.current();
  const QSignalSpy edited(&models, &ModelController::edited);
  const QSignalSpy modified(&models, &ModelController::modifiedChanged);
  fuzzy::ForceModel model = before->model;
  model.experts[0].rules[0].then = "high";
  ASSERT_TRUE(models.edit(model));
  EXPECT_EQ(edited.count(), 1);
  EXPECT_TRUE(models.isModified());
  EXPECT_EQ(models.current()->path, path);
  EXPECT_EQ(models.current()->model, model);
  EXPECT_EQ(before->model.experts[0].rules[0].then, "low");
  // Slow and near: "high" has its centroid at 0.75 N; one division.
  EXPECT_NEAR(models.current()->compiled.evaluateExpert(0, std::array{20.0, 2.0}).force_n, 0.75, 1e-15);

  ASSERT_TRUE(models.edit(before->model));
  EXPECT_FALSE(models.isModified());
  ASSERT_EQ(modified.count(), 2);
  EXPECT_TRUE(modified[0][0].toBool());
  EXPECT_FALSE(modified[1][0].toBool());
}

TEST(ModelController, AnEditWithoutSenseIsRefused) {
  const tests::ModelFolder folder;
  ModelController models;
  models.open(folder.write(tests::twoExperts()));
  const auto before = models.current();
  const QSignalSpy edited(&models, &ModelController::edited);
  fuzzy::ForceModel model = before->model;
  model.experts[0].rules[0].then = "enormous";
  const auto refused = models.edit(model);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::kReference);
  EXPECT_EQ(edited.count(), 0);
  EXPECT_EQ(models.current(), before);
  EXPECT_FALSE(models.isModified());
}

TEST(ModelController, AnEditedModelIsSavedWithItsChecks) {
  const tests::ModelFolder folder;
  ModelController models;
  fuzzy::ForceModel model = tests::twoExperts();
  model.checks = {{{20, 2}, 0.25, true}};
  models.open(folder.write(model));
  model.experts[0].rules[0].then = "high";
  ASSERT_TRUE(models.edit(model));
  const QSignalSpy saved(&models, &ModelController::saved);
  const QString copy = folder.path(QStringLiteral("copy.tactus.json"));
  models.saveAs(copy);
  ASSERT_EQ(saved.count(), 1);
  EXPECT_FALSE(models.isModified());
  EXPECT_EQ(models.current()->path, copy);

  // A second reader: the file passes its own checks and holds what was edited.
  ModelController reader;
  reader.open(copy);
  ASSERT_NE(reader.current(), nullptr);
  EXPECT_EQ(reader.current()->model, models.current()->model);
  EXPECT_NEAR(reader.current()->model.checks[0].force, 0.75, 1e-15);
  reader.open(folder.path(QStringLiteral("sample.tactus.json")));
  EXPECT_EQ(reader.current()->model.experts[0].rules[0].then, "low");
}

TEST(ModelController, AFileThatCannotBeWrittenLeavesTheModelModified) {
  const tests::ModelFolder folder;
  ModelController models;
  const QString path = folder.write(tests::twoExperts());
  models.open(path);
  fuzzy::ForceModel model = models.current()->model;
  model.name = "Edited";
  ASSERT_TRUE(models.edit(model));
  const QSignalSpy failed(&models, &ModelController::saveFailed);
  models.saveAs(folder.path(QStringLiteral("no such folder/a.tactus.json")));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][1].toString().contains(QStringLiteral("no such folder")));
  EXPECT_TRUE(models.isModified());
  EXPECT_EQ(models.current()->path, path);
}

TEST(ModelController, SimulatedDataStaySimulated) {
  const tests::ModelFolder folder;
  ModelController models;
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].label = "A (simulated)";
  models.open(folder.write(model));
  model.experts[0].label = "A";
  ASSERT_TRUE(models.edit(model));
  EXPECT_TRUE(models.current()->simulated);
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
