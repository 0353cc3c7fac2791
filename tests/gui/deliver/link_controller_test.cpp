#include "app/workbench/deliver/link/link_controller.h"

#include <QFile>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/workbench/features/features.h"
#include "app/workbench/features/felt_states.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"

#include "tests/app/link/test_client.h"
#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {
namespace {

using link::TestClient;
using nlohmann::json;

using tests::kPatience;

class LinkControllerTest : public testing::Test {
 protected:
  void open() { models.open(folder.write(tests::twoExperts())); }
  std::string token() {
    QFile file(controller.tokenFile());
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readLine().trimmed().toStdString();
  }
  TestClient connect(std::string_view more = R"("want":["model"])") {
    TestClient client(static_cast<std::uint16_t>(controller.address().section(QLatin1Char(':'), 1).toUInt()));
    EXPECT_TRUE(client.send(link::helloOf(token(), more)));
    EXPECT_NE(client.line().find("tactus-link"), std::string::npos);
    return client;
  }
  static std::string nameIn(const std::string& line) {
    return json::parse(line).at("model").at("file").at("name").get<std::string>();
  }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  LinkController controller{models};
};

TEST_F(LinkControllerTest, IsOffUntilItIsStartedWithAModel) {
  EXPECT_FALSE(controller.isServing());
  const QSignalSpy failed(&controller, &LinkController::failed);
  controller.start();
  EXPECT_EQ(failed.size(), 1);
  open();
  EXPECT_FALSE(controller.isServing());
  EXPECT_EQ(controller.address(), QString());
  controller.start();
  ASSERT_TRUE(controller.isServing());
  EXPECT_TRUE(controller.address().startsWith(QStringLiteral("127.0.0.1:")));
  const QString token_file = controller.tokenFile();
  const QString address = controller.address();
  EXPECT_TRUE(QFile::exists(token_file));
  controller.stop();
  EXPECT_FALSE(QFile::exists(token_file));
  EXPECT_EQ(controller.tokenFile(), QString());
  controller.start();
  EXPECT_EQ(controller.address(), address) << "a simulator finds it where it was";
}

TEST_F(LinkControllerTest, AChosenPortIsTheOneOrNone) {
  open();
  controller.start();
  ASSERT_TRUE(controller.isServing());
  const QString taken = controller.address();
  LinkController second(models);
  QString sentence;
  QObject::connect(&second, &LinkController::failed, [&](const QString& text) { sentence = text; });
  second.choosePort(static_cast<std::uint16_t>(taken.section(QLatin1Char(':'), 1).toUInt()));
  second.start();
  EXPECT_FALSE(second.isServing());
  EXPECT_TRUE(sentence.contains(taken.section(QLatin1Char(':'), 1))) << sentence.toStdString();
  controller.stop();
  second.start();
  EXPECT_EQ(second.address(), taken);
}

TEST_F(LinkControllerTest, EachEditIsSentAsSavingWouldWriteIt) {
  open();
  controller.start();
  TestClient client = connect();
  EXPECT_EQ(nameIn(client.line()), "Two experts");
  fuzzy::ForceModel edited = models.current()->model;
  edited.name = "Edited";
  edited.experts[0].rules[0].then = "high";
  ASSERT_TRUE(models.edit(edited));
  const std::string line = client.line();
  const QString saved = folder.path(QStringLiteral("saved.tactus.json"));
  models.saveAs(saved);
  QFile file(saved);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const json model = json::parse(line).at("model");
  EXPECT_EQ(model.at("sha256"), base::sha256(file.readAll().toStdString()));
  EXPECT_EQ(model.at("serial"), 2);
  const auto read = model_io::parseModel(model.at("file").dump(), "line");
  EXPECT_TRUE(read) << read.error().message();
}

TEST_F(LinkControllerTest, ADragEndsWithItsNewestModel) {
  open();
  controller.start();
  TestClient client = connect();
  client.line();
  fuzzy::ForceModel edited = models.current()->model;
  for (int i = 0; i < 200; ++i) {
    edited.name = "drag " + std::to_string(i);
    ASSERT_TRUE(models.edit(edited));
  }
  std::string name;
  for (int lines = 0; name != "drag 199" && lines <= 200; ++lines) name = nameIn(client.line());
  EXPECT_EQ(name, "drag 199");
}

TEST_F(LinkControllerTest, SaysWhoIsConnected) {
  open();
  controller.start();
  const TestClient first = connect(R"("name":"Phantom 2","want":["state"])");
  const TestClient second = connect();
  ASSERT_TRUE(QTest::qWaitFor([&] { return controller.clients().size() == 2; }, kPatience));
  EXPECT_EQ(controller.clients()[0].name, "Phantom 2");
  EXPECT_TRUE(controller.clients()[0].wants_state);
  EXPECT_TRUE(controller.wantsStates());
  controller.stop();
  EXPECT_TRUE(controller.clients().empty());
  EXPECT_FALSE(controller.wantsStates());
}

std::string feltAt(double depth_mm, const std::string& conditions = "{}") {
  return R"({"felt":{"time_s":1,"speed_mm_s":20,"force_n":0.3,"depth_mm":)" + std::to_string(depth_mm) +
         R"(,"conditions":)" + conditions + "}}\n";
}

TEST_F(LinkControllerTest, ASimulatorIsThereWhileItSaysWhereItIs) {
  open();
  controller.start();
  const QSignalSpy moved(&controller, &LinkController::simulatorsMoved);
  const double value_before = scene.value(0);
  TestClient client = connect(R"("name":"Phantom 2","want":[])");
  EXPECT_TRUE(controller.simulators().empty());
  std::string flood;
  for (int i = 0; i <= 5000; ++i) flood += feltAt(i * 0.001);
  ASSERT_TRUE(client.send(flood));
  const auto is_at = [&](double depth_mm) {
    return controller.simulators().size() == 1 && controller.simulators()[0].felt.depth_mm == depth_mm;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return is_at(5); }, kPatience));
  EXPECT_EQ(controller.simulators()[0].name, QStringLiteral("Phantom 2"));
  EXPECT_LT(moved.size(), 500) << "a flood is looked at frame by frame";
  EXPECT_EQ(scene.value(0), value_before) << "nothing else moves";
  // Silent, it is gone, though it is connected; then it is there again, and gone when it leaves.
  ASSERT_TRUE(QTest::qWaitFor([&] { return controller.simulators().empty(); }, kPatience));
  EXPECT_EQ(controller.clients().size(), 1U);
  ASSERT_TRUE(client.send(feltAt(3)));
  ASSERT_TRUE(QTest::qWaitFor([&] { return is_at(3); }, kPatience));
  ASSERT_TRUE(client.send("nonsense\n"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return controller.simulators().empty(); }, kPatience));
  EXPECT_TRUE(QTest::qWaitFor([&] { return controller.clients().empty(); }, kPatience));
}

TEST_F(LinkControllerTest, TheEndOfServingIsTheEndOfAllSimulators) {
  open();
  controller.start();
  TestClient client = connect();
  ASSERT_TRUE(client.send(feltAt(1)));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !controller.simulators().empty(); }, kPatience));
  const QSignalSpy moved(&controller, &LinkController::simulatorsMoved);
  controller.stop();
  EXPECT_TRUE(controller.simulators().empty());
  EXPECT_EQ(moved.size(), 1);
}

TEST_F(LinkControllerTest, WhatTheHandFeelsIsSentWithItsSetting) {
  open();
  tests::SteppedFeel time;
  DeviceSession session{time.settings()};
  FeelController feel{scene, session};
  FeltStates felt{feel, scene};
  EXPECT_TRUE(felt.afterRun().states.empty()) << "nothing was felt yet";
  link::LinkStates states;
  QObject::connect(&feel, &FeelController::sampled, &feel,
                   [&](std::span<const haptics::Sample> samples) { states = felt.of(samples); });
  feel.start(QStringLiteral("virtual"));
  time.advance(feel, 20);
  feel.session().setHeld(true);
  time.advance(feel, 1200);
  time.moveTo(feel, 5, 5);
  ASSERT_FALSE(states.states.empty());
  const link::LinkState last = states.states.back();
  const haptics::Sample& sample = feel.latest();
  EXPECT_EQ(last.depth_mm, feel.depthMm());
  EXPECT_EQ(last.force_n, sample.force_n);
  EXPECT_EQ(last.model_force_n, sample.model_force_n);
  EXPECT_EQ(last.stroke, 1U);
  EXPECT_TRUE(last.held);
  EXPECT_GT(last.time_s, 1.2);
  EXPECT_LT(last.time_s, 10);
  EXPECT_TRUE(states.setting->simulated);
  EXPECT_TRUE(states.setting->conditions.empty()) << "the sample model has speed and depth alone";
  // Near until 5 mm, far from 6 mm on: the terms do not touch.
  ASSERT_EQ(states.setting->regions.size(), 2U);
  EXPECT_EQ(states.setting->regions[0].id, "near");
  EXPECT_NEAR(states.setting->regions[0].to_mm, 5, 0.01);
  EXPECT_EQ(states.setting->regions[1].id, "far");

  feel.stop();
  const auto after = felt.afterRun();
  ASSERT_EQ(after.states.size(), 1U);
  EXPECT_EQ(after.states[0].force_n, 0);
  EXPECT_FALSE(after.states[0].held);
  EXPECT_TRUE(after.setting->simulated);
}

}  // namespace
}  // namespace tactus::workbench
