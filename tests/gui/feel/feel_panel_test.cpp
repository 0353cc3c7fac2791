#include "app/workbench/feel/feel_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/stepped_feel.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

class FeelPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    panel.resize(440, 900);
    panel.show();
    models.open(folder.write(tests::twoExperts()));
    QCoreApplication::processEvents();
  }

  template <class Widget>
  Widget* saying(const QString& text) {
    const QList<Widget*> all = panel.findChildren<Widget*>();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Widget* widget) {
      return widget->isVisibleTo(&panel) && widget->text().contains(text);
    });
    return found == all.end() ? nullptr : *found;
  }

  void click(const QString& button) { QTest::mouseClick(saying<QPushButton>(button), Qt::LeftButton); }

  // Takes the tube in the pad and pushes it to the right.
  void push() {
    TubePad* pad = panel.findChild<TubePad*>();
    time.advance(feel, 20);  // the hand has to be seen open once
    QTest::mousePress(pad, Qt::LeftButton, Qt::NoModifier, {40, 20});
    time.advance(feel, 1500);
    for (int x = 41; x <= 50; ++x) {
      QTest::mouseMove(pad, {x, 20});
      time.advance(feel, 100);
    }
  }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  tests::SteppedFeel time;
  DeviceSession device_session{time.settings()};
  FeelController feel{scene, device_session};
  FeelPanel panel{scene, feel};
};

TEST_F(FeelPanelTest, HasTheConditionsAndStepsOfTheProcedure) {
  const auto catheter = procedure::builtIn("male-urethral-catheter");
  auto open = templateModel(*catheter, QStringLiteral("x"), folder.path(QString()));
  ASSERT_TRUE(open) << open.error().message();
  fuzzy::ForceModel model = open->model;
  model.experts[0].rules.push_back({{{"depth", "bulb"}}, "large"});
  model.provenance.emplace();
  model.provenance->settings.push_back(procedure::modelSetting(*catheter));
  models.open(folder.write(model, QStringLiteral("catheter.tactus.json")));
  QCoreApplication::processEvents();
  ASSERT_EQ(scene.procedure(), catheter);
  // One of the words of each condition; no gesture for the pose, because the pack has no words for one.
  EXPECT_NE(saying<QPushButton>("Half raised"), nullptr);
  EXPECT_EQ(saying<QPushButton>("Flex the neck"), nullptr);
  click("Generous");
  EXPECT_EQ(scene.value(0), 0.9);  // 0.8 to 1 is fully generous
  EXPECT_NE(saying<QLabel>(QString::fromStdString(procedure::textIn(catheter->steps.front().title, "en"))), nullptr);

  models.open(folder.write(support::s4FiveRegions(), QStringLiteral("ngt.tactus.json")));
  QCoreApplication::processEvents();
  EXPECT_EQ(saying<QPushButton>("Generous"), nullptr);
  EXPECT_NE(saying<QPushButton>("oor"), nullptr);
  EXPECT_TRUE(saying<QPushButton>("Flex the neck") != nullptr || saying<QPushButton>("Raise head") != nullptr);
}

TEST_F(FeelPanelTest, TheBodyInThreeDimensionsTakesThePlaceOfThePicture) {
  models.open(folder.write(support::s4FiveRegions(), QStringLiteral("ngt.tactus.json")));
  QCoreApplication::processEvents();
  auto* const solid = panel.findChild<anatomy::SolidView*>();
  auto* const flat = panel.findChild<anatomy::BodyView*>();
  EXPECT_FALSE(solid->isVisible());  // off at first
  EXPECT_TRUE(flat->isVisible());
  QSignalSpy changes(&panel, &FeelPanel::solidChanged);
  QTest::mouseClick(saying<QCheckBox>("3-D view"), Qt::LeftButton, Qt::NoModifier, {8, 8});
  EXPECT_TRUE(solid->isVisible());
  EXPECT_FALSE(flat->isVisible());
  ASSERT_EQ(changes.size(), 1);
  EXPECT_TRUE(changes[0][0].toBool());

  panel.setSolid(false);
  EXPECT_TRUE(flat->isVisible());
  EXPECT_FALSE(solid->isVisible());
}

TEST_F(FeelPanelTest, SaysWhyThereIsNoBodyInThreeDimensions) {
  auto plain = std::make_shared<procedure::Procedure>(*procedure::defaultProcedure());
  plain->id = "other";
  plain->pictures.clear();
  scene.setStudyProcedure(plain);
  fuzzy::ForceModel model = support::s4FiveRegions();
  model.provenance.emplace();
  model.provenance->settings.push_back(procedure::modelSetting(*plain));
  models.open(folder.write(model, QStringLiteral("other.tactus.json")));
  panel.setSolid(true);
  QCoreApplication::processEvents();
  ASSERT_EQ(scene.procedure(), plain);
  EXPECT_NE(saying<QLabel>("There is no 3-D view: this procedure has no picture"), nullptr);
  EXPECT_FALSE(panel.findChild<anatomy::SolidView*>()->isVisible());
  EXPECT_TRUE(panel.findChild<anatomy::BodyView*>() != nullptr);
  panel.setSolid(false);
  EXPECT_EQ(saying<QLabel>("There is no 3-D view"), nullptr);
}

TEST_F(FeelPanelTest, SaysThatTheVirtualDeviceIsSimulated) { EXPECT_NE(saying<QLabel>("SIMULATED"), nullptr); }

TEST_F(FeelPanelTest, TheMousePushesTheTubeAndTheForceIsShown) {
  click("Start");
  push();
  EXPECT_TRUE(feel.latest().enabled);
  EXPECT_GT(feel.latest().force_n, 0.05);
  EXPECT_NE(saying<QLabel>("1 stroke"), nullptr);
  EXPECT_EQ(saying<QLabel>("0.000 N"), nullptr);
  QTest::mouseRelease(panel.findChild<TubePad*>(), Qt::LeftButton, Qt::NoModifier, {50, 20});
  time.advance(feel, 60);
  EXPECT_NE(saying<QLabel>("0.000 N"), nullptr);
  click("Stop");
  // In a line that ends where the panel does; the tool tip has all of it.
  const QList<QLabel*> labels = panel.findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    const QString start = QStringLiteral("Last placement, SIMULATED");
    return label->text().startsWith(start) || label->toolTip().startsWith(start);
  }));
}

TEST_F(FeelPanelTest, SpaceHoldsTheTubeAndEscapeStops) {
  click("Start");
  time.advance(feel, 50);
  QTest::keyPress(&panel, Qt::Key_Space);
  time.advance(feel, 50);
  EXPECT_TRUE(feel.latest().enabled);
  QTest::keyRelease(&panel, Qt::Key_Space);
  time.advance(feel, 50);
  EXPECT_FALSE(feel.latest().enabled);
  QTest::keyPress(&panel, Qt::Key_Escape);
  EXPECT_FALSE(feel.isRunning());
}

TEST_F(FeelPanelTest, SpaceHoldsTheTubeWhileTheKeyboardIsInANumber) {
  click("Start");
  time.advance(feel, 50);
  QDoubleSpinBox number;
  number.show();
  number.setFocus();
  QTest::keyPress(&number, Qt::Key_Space);
  time.advance(feel, 50);
  EXPECT_TRUE(feel.latest().enabled);
  QTest::keyRelease(&number, Qt::Key_Space);
  // A menu that opens has its own use for the key.
  QMenu menu;
  menu.addAction(QStringLiteral("Something"));
  menu.popup(QPoint(0, 0));
  QTest::keyPress(&menu, Qt::Key_Space);
  time.advance(feel, 50);
  EXPECT_FALSE(feel.latest().enabled);
}

TEST_F(FeelPanelTest, APadThatIsHiddenLetsGo) {
  click("Start");
  push();
  ASSERT_TRUE(feel.latest().enabled);
  panel.hide();
  time.advance(feel, 60);
  EXPECT_FALSE(feel.latest().enabled);
}

TEST_F(FeelPanelTest, ItsOwnKeyStopsTheForceWhateverHasTheKeyboard) {
  click("Start");
  time.advance(feel, 50);
  QWidget other;
  other.show();
  QTest::keyPress(&other, Qt::Key_F12);
  EXPECT_FALSE(feel.isRunning());
}

// A widget that wants Escape for itself, as a plot does while something is dragged.
class Dragged : public QWidget {
 public:
  bool cancelled = false;

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride) {
      event->accept();
      return true;
    }
    return QWidget::event(event);
  }
  void keyPressEvent(QKeyEvent* event) override { cancelled = event->key() == Qt::Key_Escape; }
};

TEST_F(FeelPanelTest, EscapeTakesADragBackAndLeavesTheForce) {
  click("Start");
  time.advance(feel, 50);
  Dragged dragged;
  dragged.show();
  QTest::keyPress(&dragged, Qt::Key_Escape);
  EXPECT_TRUE(dragged.cancelled);
  EXPECT_TRUE(feel.isRunning());
  QTest::keyPress(&panel, Qt::Key_Escape);
  EXPECT_FALSE(feel.isRunning());
}

TEST_F(FeelPanelTest, ALatchTakesTheTubeWithOnePress) {
  auto* grip = panel.findChildren<QComboBox*>().back();
  grip->setCurrentIndex(1);
  emit grip->activated(1);
  EXPECT_TRUE(feel.session().grip().latch);
  click("Start");
  time.advance(feel, 50);
  const auto press = [this] {
    QTest::keyPress(&panel, Qt::Key_Space);
    time.advance(feel, 50);
    QTest::keyRelease(&panel, Qt::Key_Space);
    time.advance(feel, 50);
  };
  press();
  EXPECT_TRUE(feel.latest().enabled);
  press();
  EXPECT_FALSE(feel.latest().enabled);
  // Drawn out beyond the release zone of -20 mm it lets go by itself.
  // A click of the mouse may be shorter than the switch of a device bounces, or than the screen stands still.
  for (const int down_ms : {5, 0}) {
    for (const bool on : {true, false}) {
      QTest::keyPress(&panel, Qt::Key_Space);
      time.hang(down_ms);
      QTest::keyRelease(&panel, Qt::Key_Space);
      time.advance(feel, 100);
      EXPECT_EQ(feel.latest().enabled, on) << down_ms;
    }
  }
  press();
  ASSERT_TRUE(feel.latest().enabled);
  time.moveTo(feel, -40, 100);
  EXPECT_FALSE(feel.latest().enabled);
}

TEST_F(FeelPanelTest, NothingIsCutInTheSmallestPlace) {
  panel.resize(590, 296);
  QCoreApplication::processEvents();
  const auto* area = panel.findChild<QScrollArea*>();
  for (const bool split : {false, true}) {
    panel.findChildren<QCheckBox*>().front()->setChecked(split);
    QCoreApplication::processEvents();
    EXPECT_LE(area->widget()->height(), area->viewport()->height()) << split;
    EXPECT_LE(area->widget()->minimumSizeHint().width(), area->viewport()->width()) << split;
  }
}

TEST_F(FeelPanelTest, TheForceCanBeSplit) {
  EXPECT_EQ(saying<QLabel>("fuzzy force"), nullptr);
  panel.findChildren<QCheckBox*>().front()->setChecked(true);
  EXPECT_NE(saying<QLabel>("fuzzy force"), nullptr);
}

TEST_F(FeelPanelTest, AFailureIsSaidInTheDeviceCardAndOfferedAgain) {
  fuzzy::ForceModel inches = tests::twoExperts();
  inches.inputs[1].unit = "in";
  models.open(folder.write(inches, QStringLiteral("inches.tactus.json")));
  click("Start");
  EXPECT_NE(saying<QLabel>("The device did not start. "), nullptr);
  EXPECT_NE(saying<QLabel>("'in'"), nullptr);
  EXPECT_FALSE(feel.isRunning());
  models.open(folder.write(tests::twoExperts()));
  ASSERT_NE(saying<QPushButton>("Try again"), nullptr);
  click("Try again");
  EXPECT_TRUE(feel.isRunning());
  EXPECT_EQ(saying<QLabel>("did not start"), nullptr);
  EXPECT_EQ(saying<QPushButton>("Try again"), nullptr);
}

}  // namespace
}  // namespace tactus::workbench
