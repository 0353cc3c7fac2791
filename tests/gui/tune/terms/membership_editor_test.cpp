#include "app/workbench/tune/terms/membership_editor.h"

#include <QLineEdit>
#include <QMenu>
#include <QStyle>
#include <QTabBar>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/tune/terms/term_controller.h"

#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

using Points = std::vector<double>;

class MembershipEditorTest : public testing::Test {
 protected:
  void SetUp() override {
    models.open(folder.write(tests::twoExperts()));
    editor.resize(720, 560);
    editor.show();
    QCoreApplication::processEvents();
    plot = editor.findChild<MembershipEditorPlot*>();
    // The drawing fills the plot and gets the mouse.
    canvas = plot->findChild<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
  }

  const Points& points(std::size_t term) const { return terms.terms()[term].points; }

  QPoint place(double x, double membership) const {
    return canvas->mapFrom(plot, plot->pixelOf(x, membership).toPoint());
  }

  /// How much of the universe a pixel is.
  double perPixel() const { return 1 / (plot->pixelOf(1, 0).x() - plot->pixelOf(0, 0).x()); }

  void press(QPoint at) { QTest::mousePress(canvas, Qt::LeftButton, {}, at); }
  void move(QPoint at) { QTest::mouseMove(canvas, at); }
  void release(QPoint at) { QTest::mouseRelease(canvas, Qt::LeftButton, {}, at); }
  void drag(QPoint from, int by_px) {
    press(from);
    for (int i = 1; i <= 4; ++i) move(from + QPoint(by_px * i / 4, 0));
    release(from + QPoint(by_px, 0));
    QCoreApplication::processEvents();
  }

  template <class Widget>
  Widget* named(const QString& name) const {
    const QList<Widget*> all = editor.findChildren<Widget*>();
    const auto found = std::find_if(all.begin(), all.end(), [&](auto* w) { return w->accessibleName() == name; });
    return found == all.end() ? nullptr : *found;
  }

  /// Split and remove.
  QList<QAction*> more(const char* term) const {
    return named<QToolButton>(QStringLiteral("More for %1").arg(QLatin1String(term)))->findChild<QMenu*>()->actions();
  }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  EditController edits{models};
  TermController terms{edits};
  GhostController ghost{edits, scene};
  MembershipEditor editor{edits, terms, scene, ghost};
  MembershipEditorPlot* plot = nullptr;
  QWidget* canvas = nullptr;
};

// The values of depth, 0 to 10 mm, are rounded to a hundredth of a mm; a pixel of the mouse is a few of these.
constexpr double kRounded = 0.0051;

TEST_F(MembershipEditorTest, AVertexFollowsTheMouse) {
  drag(place(5, 0), 60);
  EXPECT_NEAR(points(0)[3], 5 + 60 * perPixel(), kRounded);
  EXPECT_EQ(points(0)[2], 4);
  EXPECT_EQ(models.current()->model, edits.model());
  EXPECT_EQ(edits.history().line().size(), 2U);
  edits.undo();
  EXPECT_EQ(edits.model(), tests::twoExperts());
}

TEST_F(MembershipEditorTest, AnEdgeAndATermFollowTheMouse) {
  drag(place(6.5, 0.5), 40);
  EXPECT_NEAR(points(1)[0], 6 + 40 * perPixel(), kRounded);
  EXPECT_NEAR(points(1)[1], 7 + 40 * perPixel(), kRounded);
  edits.undo();
  drag(place(2, 0.5), 30);
  EXPECT_NEAR(points(0)[0], 30 * perPixel(), kRounded);
  EXPECT_NEAR(points(0)[3], 5 + 30 * perPixel(), kRounded);
}

TEST_F(MembershipEditorTest, AVertexStopsAtItsNeighbor) {
  drag(place(4, 1), 250);
  EXPECT_EQ(points(0), (Points{0, 0, 5, 5}));
  drag(place(6, 0), 300);
  EXPECT_EQ(points(1), (Points{7, 7, 10, 10}));
}

TEST_F(MembershipEditorTest, AClickSelectsAndChangesNothing) {
  drag(place(5, 0), 0);
  EXPECT_EQ(terms.selected(), (Grip{0, Grip::Part::kVertex, 3, false}));
  EXPECT_FALSE(edits.canUndo());
}

TEST_F(MembershipEditorTest, EscapeTakesADragBack) {
  const QPoint from = place(5, 0);
  press(from);
  move(from + QPoint(50, 0));
  EXPECT_GT(points(0)[3], 5);
  QTest::keyClick(plot, Qt::Key_Escape);
  EXPECT_EQ(edits.model(), tests::twoExperts());
  move(from + QPoint(80, 0));
  release(from + QPoint(80, 0));
  EXPECT_EQ(edits.model(), tests::twoExperts());
  EXPECT_FALSE(edits.canUndo());
}

TEST_F(MembershipEditorTest, UndoInTheMiddleOfADragEndsIt) {
  const QPoint from = place(5, 0);
  press(from);
  move(from + QPoint(50, 0));
  edits.undo();
  move(from + QPoint(80, 0));
  release(from + QPoint(80, 0));
  EXPECT_EQ(edits.model(), tests::twoExperts());
}

TEST_F(MembershipEditorTest, ArrowKeysMoveWhatIsSelected) {
  terms.setVariable("speed");
  terms.setKeepsSum(false);
  drag(place(60, 0), 0);
  QTest::keyClick(plot, Qt::Key_Right);
  EXPECT_EQ(points(0)[3], 61);
  QTest::keyClick(plot, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(points(0)[3], 51);
  EXPECT_EQ(edits.history().line().size(), 3U);
  QTest::keyClick(plot, Qt::Key_Up);
  EXPECT_EQ(terms.selected(), (Grip{0, Grip::Part::kVertex, 2, false}));
}

TEST_F(MembershipEditorTest, ALockedVertexDoesNotFollow) {
  auto* lock = named<LockButton>(QStringLiteral("Lock the right foot of Near"));
  ASSERT_NE(lock, nullptr);
  QTest::mouseClick(lock, Qt::LeftButton);
  EXPECT_TRUE(terms.isLocked("near", 3));
  drag(place(5, 0), 60);
  EXPECT_EQ(edits.model(), tests::twoExperts());
  QTest::mouseClick(lock, Qt::LeftButton);
  drag(place(5, 0), 60);
  EXPECT_NEAR(points(0)[3], 5 + 60 * perPixel(), kRounded);
}

TEST_F(MembershipEditorTest, NeighborsThatSumToOneFollow) {
  auto* variables = editor.findChild<QTabBar*>();
  QTest::mouseClick(variables, Qt::LeftButton, {}, variables->tabRect(0).center());
  ASSERT_EQ(terms.list().variable, "speed");
  drag(place(60, 0), 50);
  EXPECT_NEAR(points(0)[3], 60 + 50 * perPixel(), 0.051);  // speed is rounded to a tenth of a mm/s
  EXPECT_EQ(points(1)[1], points(0)[3]);
}

TEST_F(MembershipEditorTest, ANumberCanBeTyped) {
  auto* number = named<NumberBox>(QStringLiteral("Near: right foot"));
  ASSERT_NE(number, nullptr);
  number->selectAll();
  QTest::keyClicks(number, QStringLiteral("5.25"));
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(points(0)[3], 5.25);
  edits.undo();
  EXPECT_EQ(number->value(), 5);
  number->selectAll();
  QTest::keyClicks(number, QStringLiteral("2"));  // left of the shoulder
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(points(0)[3], 4);
  EXPECT_EQ(number->value(), 4);
}

TEST_F(MembershipEditorTest, ATermIsRenamedInItsRow) {
  auto* name = named<QLineEdit>(QStringLiteral("Name of Far"));
  ASSERT_NE(name, nullptr);
  name->selectAll();
  QTest::keyClicks(name, QStringLiteral("Deep"));
  QTest::keyClick(name, Qt::Key_Return);
  EXPECT_EQ(terms.terms()[1].label, "Deep");
  EXPECT_EQ(terms.terms()[1].id, "far");
  // Its row says so, to a screen reader too, and shows what an undo brings back while the keyboard is still there.
  EXPECT_NE(named<QToolButton>(QStringLiteral("More for Deep")), nullptr);
  edits.undo();
  EXPECT_EQ(name->text(), QStringLiteral("Far"));
}

TEST_F(MembershipEditorTest, ASmallFormSplitsATerm) {
  more("Far")[0]->trigger();
  auto* form = editor.findChild<PopupForm*>();
  ASSERT_NE(form, nullptr);
  auto* cuts = form->findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
  ASSERT_NE(cuts, nullptr);
  EXPECT_EQ(cuts->text(), QStringLiteral("8.5"));  // the middle of the core, 7 to 10
  QTest::keyClick(cuts, Qt::Key_Return);
  EXPECT_EQ(terms.terms().size(), 3U);
  edits.undo();
  EXPECT_EQ(edits.model(), tests::twoExperts());
}

TEST_F(MembershipEditorTest, TheCutsOfASplitAreDraggedInAPicture) {
  more("Far")[0]->trigger();
  auto* form = editor.findChild<PopupForm*>();
  ASSERT_NE(form, nullptr);
  auto* cuts = form->findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
  auto* picture = form->findChild<CutPicture*>();
  ASSERT_NE(picture, nullptr);
  ASSERT_EQ(picture->cuts(), Points{8.5});
  const auto at = [picture](double value) { return QPoint(qRound(picture->pixelOf(value)), 20); };
  QTest::mousePress(picture, Qt::LeftButton, {}, at(8.5));
  QTest::mouseMove(picture, at(9.2));
  QTest::mouseRelease(picture, Qt::LeftButton, {}, at(9.2));
  ASSERT_EQ(picture->cuts().size(), 1U);
  const double per_pixel = 1 / (picture->pixelOf(9) - picture->pixelOf(8));
  EXPECT_NEAR(picture->cuts()[0], 9.2, per_pixel);
  EXPECT_EQ(cuts->text(), text(editing::numberText(terms.variable(), picture->cuts()[0])));
  // Away from a cut there is nothing to drag.
  QTest::mousePress(picture, Qt::LeftButton, {}, at(7.5));
  QTest::mouseMove(picture, at(7));
  QTest::mouseRelease(picture, Qt::LeftButton, {}, at(7));
  EXPECT_NEAR(picture->cuts()[0], 9.2, per_pixel);
  // What is typed is drawn, and a key moves it by a fine step.
  cuts->selectAll();
  QTest::keyClicks(cuts, QStringLiteral("8; 9.5"));
  EXPECT_EQ(picture->cuts(), (Points{8, 9.5}));
  QTest::keyClick(picture, Qt::Key_Down);
  QTest::keyClick(picture, Qt::Key_Left);
  EXPECT_DOUBLE_EQ(picture->cuts()[1], 9.5 - editing::editStep(terms.variable(), editing::StepSize::kFine));
  EXPECT_EQ(picture->cuts()[0], 8);
}

TEST_F(MembershipEditorTest, ATermWithRulesIsRemovedAfterASmallForm) {
  more("Far")[1]->trigger();
  auto* form = editor.findChild<PopupForm*>();
  ASSERT_NE(form, nullptr);
  EXPECT_EQ(terms.terms().size(), 2U);
  QTest::keyClick(form, Qt::Key_Return);
  EXPECT_EQ(terms.terms().size(), 1U);
}

TEST_F(MembershipEditorTest, ASliderMovesAVertexOfTheChosenTerm) {
  terms.select(Grip{0, Grip::Part::kTerm, 0, false});
  const std::string label = labelOf(terms.terms()[0]).toStdString();
  auto* slider = named<VertexSlider>(QString::fromStdString("Right foot of " + label));
  ASSERT_NE(slider, nullptr);
  const Points before = points(0);
  const double range = terms.variable().max - terms.variable().min;
  const double per_pixel =
      range / (slider->width() - slider->style()->pixelMetric(QStyle::PM_SliderLength, nullptr, slider));
  QTest::mousePress(slider, Qt::LeftButton, {}, {20, 8});
  QTest::mouseMove(slider, {24, 8});
  QTest::mouseMove(slider, {30, 8});
  EXPECT_TRUE(edits.inGesture());
  QTest::mouseRelease(slider, Qt::LeftButton, {}, {30, 8});
  EXPECT_NEAR(points(0)[3], before[3] + 10 * per_pixel, range / 1000);
  EXPECT_FALSE(edits.inGesture());
  edits.undo();
  EXPECT_EQ(points(0), before);

  // An arrow key is a fine step, and Escape takes a drag back.
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_GT(points(0)[3], before[3]);
  edits.undo();
  QTest::mousePress(slider, Qt::LeftButton, {}, {20, 8});
  QTest::mouseMove(slider, {40, 8});
  QTest::keyClick(slider, Qt::Key_Escape);
  EXPECT_EQ(points(0), before);
  QTest::mouseRelease(slider, Qt::LeftButton, {}, {40, 8});
  EXPECT_EQ(points(0), before);
}

TEST_F(MembershipEditorTest, TheSlidersHaveTheEndsOfAnotherModel) {
  const auto far_right = [this] { return named<VertexSlider>(QStringLiteral("Right foot of Near")); };
  ASSERT_EQ(far_right()->value(), 5000);  // 5 of 10 mm
  fuzzy::ForceModel longer = tests::twoExperts();
  longer.inputs[1].max = 20;
  models.open(folder.write(longer, QStringLiteral("longer.tactus.json")));
  QCoreApplication::processEvents();
  EXPECT_EQ(far_right()->value(), 2500);
}

TEST_F(MembershipEditorTest, TheRoomBelowTheTableGoesToThePlot) {
  const int small = plot->height();
  editor.resize(720, 900);
  QCoreApplication::processEvents();
  EXPECT_EQ(plot->height() - small, 900 - 560);
}

}  // namespace
}  // namespace tactus::workbench
