#include "app/workbench/labs/depth/depth_lab.h"

#include <QPainter>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "app/workbench/labs/depth/depth_canvas.h"
#include "app/workbench/labs/depth/depth_lab_view.h"
#include "app/workbench/labs/depth/image_reader.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "core/store/depth_records.h"

#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class DepthLabTest : public testing::Test {
 protected:
  void SetUp() override {
    tests::makeStudyFile(path);
    study.open(path);
    screen.addLab(QStringLiteral("Depth"), view, &lab);
    screen.resize(1200, 700);
    screen.show();
    ASSERT_TRUE(comesTrue([this] { return study.isOpen() && !study.isOpening(); }));
  }
  void settle() {
    ASSERT_TRUE(comesTrue([this] { return !study.isBusy(); }));
  }
  /// A gray image of 300 x 400 px as a file.
  QString imageFile() const {
    QImage image(300, 400, QImage::Format_Grayscale8);
    image.fill(Qt::lightGray);
    const QString file = folder.filePath(QStringLiteral("scan.png"));
    EXPECT_TRUE(image.save(file));
    return file;
  }
  void click(const elicitation::ImagePoint& point) {
    QTest::mouseClick(&view->canvas(), Qt::LeftButton, {}, view->canvas().onScreen(point).toPoint());
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("study.tactus"));
  StudyConnection study;
  LabData data{study};
  DepthLab lab{data, [] { return QStringLiteral("tester"); }};
  LabScreen screen{data};
  DepthLabView* view = new DepthLabView(lab);
};

TEST_F(DepthLabTest, ClicksMakeTheWayAndEachIsStoredAndUndone) {
  view->load(imageFile());
  ASSERT_EQ(view->canvas().image().size(), QSize(300, 400));
  click({50, 50});
  click({50, 350});
  ASSERT_TRUE(lab.path());
  // 300 px of 0.33 mm; a click is a pixel of the screen, which is less than one of the image's millimeters.
  EXPECT_NEAR(lab.path()->lengthMm(), 99, 1.5);
  settle();
  QTest::keyClick(&screen, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(lab.path());
  EXPECT_EQ(lab.measurement().path.size(), 1U);
  QTest::keyClick(&screen, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(lab.path());
  settle();
  const auto kept = lab.measurement();

  // It is there after the study was closed.
  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  EXPECT_TRUE(lab.measurement().path.empty());
  const auto stored = store::depthMeasurement(tests::lookInto(path));
  ASSERT_TRUE(stored && *stored);
  EXPECT_TRUE((*stored)->image_of) << "the image is stored once";
  study.open(path);
  ASSERT_TRUE(comesTrue([&] { return lab.measurement() == kept; }));
  EXPECT_EQ(view->canvas().image().size(), QSize(300, 400));
}

TEST_F(DepthLabTest, ADraggedBoundaryMovesTheTerms) {
  view->showExample();
  ASSERT_TRUE(lab.path());
  const QPointF from = view->canvas().onScreen(lab.path()->at(70));
  const QPointF to = view->canvas().onScreen(lab.path()->at(80));
  QTest::mousePress(&view->canvas(), Qt::LeftButton, {}, from.toPoint());
  QMouseEvent move(QEvent::MouseMove, to, view->canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&view->canvas(), &move);
  QTest::mouseRelease(&view->canvas(), Qt::LeftButton, {}, to.toPoint());
  EXPECT_NEAR(lab.measurement().boundaries[0].depth_mm, 80, 1);
  EXPECT_NEAR(lab.terms().terms[0].points[3], 90, 1);
  EXPECT_NEAR(lab.terms().terms[1].points[0], 70, 1);
}

// facts/participant.md 1.4: the landmarks of the drawing, mm, at their depths.
TEST_F(DepthLabTest, TheExampleHasItsDepthsWithinAMillimeter) {
  const ExampleImage example = exampleImage();
  const auto way = elicitation::TubePath::through(example.path, example.mm_per_px);
  ASSERT_TRUE(way);
  EXPECT_NEAR(example.mm_per_px, 0.33, 0.001);
  EXPECT_NEAR(way->lengthMm(), 514, 1);
  // The drawing is 620 mm high and begins at (-152, -168) mm; narrower than the image, so it is in its middle.
  const double left_mm = -152 + 412 / 2.0 - example.image.width() * example.mm_per_px / 2;
  const double top_mm = -168 + 620 / 2.0 - example.image.height() * example.mm_per_px / 2;
  struct Row {
    double depth_mm, x, y;
  };
  for (const Row& row : {Row{20, 16.3, -7.8},
                         {64, 60, -2.3},
                         {94, 85.6, 10},
                         {115, 90.1, 30.4},
                         {150, 90.5, 65.4},
                         {200, 102, 113.9},
                         {290, 127.5, 200},
                         {440, 105.4, 343.9},
                         {470, 96.7, 372.5}}) {
    const elicitation::ImagePoint place{(row.x - left_mm) / example.mm_per_px, (row.y - top_mm) / example.mm_per_px};
    EXPECT_NEAR(way->depthNear(place), row.depth_mm, 1) << row.depth_mm;
  }
}

TEST_F(DepthLabTest, WhatIsNoImageIsSaidAndDicomHasAWayOut) {
  EXPECT_FALSE(readImage("no image", QStringLiteral("a.txt")));
  QByteArray dicom(128, '\0');
  dicom += "DICM";
  const auto refused = readImage(dicom, QStringLiteral("scan.dcm"));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("dcm2img"), std::string::npos);
}

}  // namespace
}  // namespace tactus::workbench
