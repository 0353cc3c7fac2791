#include <QElapsedTimer>
#include <QImage>
#include <QTest>
#include <gtest/gtest.h>
#include <iostream>

#include "app/workbench/anatomy/body_view.h"

namespace tactus::workbench::anatomy {
namespace {

QImage pictureOf(QWidget& view) { return view.grab().toImage().convertToFormat(QImage::Format_RGB32); }

int pixelsThatDiffer(const QImage& a, const QImage& b) {
  int out = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) out += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  }
  return out;
}

TEST(SolidView, EveryProcedureThatTheProgramCarriesHasOne) {
  for (const std::string& id : procedure::builtInIds())
    EXPECT_EQ(SolidView::missing(procedure::builtIn(id).get()).toStdString(), "") << id;
}

TEST(SolidView, SaysWhyThereIsNone) {
  EXPECT_TRUE(SolidView::missing(nullptr).contains(QLatin1String("not known")));
  procedure::Procedure other = *procedure::builtIn("nasopharyngeal-swab");
  other.pictures[0].outline.clear();
  EXPECT_TRUE(SolidView::missing(&other).contains(QLatin1String("outline")));
  other.pictures.clear();
  EXPECT_TRUE(SolidView::missing(&other).contains(QLatin1String("no picture")));
}

TEST(SolidView, TheToolMovesInAllThreeViews) {
  for (const std::string& id : procedure::builtInIds()) {
    SolidView view(nullptr);
    view.resize(900, 300);  // one row: each third is a view
    view.setAbout(procedure::builtIn(id));
    view.setDepth(0);
    const QImage before = pictureOf(view);
    view.setDepth(60);
    const QImage after = pictureOf(view);
    for (int third = 0; third < 3; ++third) {
      const QRect place(third * 300, 0, 300, 300);
      EXPECT_GT(pixelsThatDiffer(before.copy(place), after.copy(place)), 20) << id << " " << third;
    }
    // No pixel tells these apart.
    view.setDepth(60.05);
    EXPECT_EQ(pixelsThatDiffer(after, pictureOf(view)), 0);
  }
}

TEST(SolidView, KeysTurnTheThirdViewAloneAndHomeTurnsItBack) {
  SolidView view(nullptr);
  view.resize(900, 300);
  view.setAbout(procedure::builtIn("nasopharyngeal-swab"));
  const QImage first = pictureOf(view);
  QTest::keyClick(&view, Qt::Key_Right);
  QTest::keyClick(&view, Qt::Key_Down);
  const QImage turned = pictureOf(view);
  EXPECT_EQ(pixelsThatDiffer(first.copy(0, 0, 600, 300), turned.copy(0, 0, 600, 300)), 0);
  EXPECT_GT(pixelsThatDiffer(first.copy(600, 0, 300, 300), turned.copy(600, 0, 300, 300)), 500);
  QTest::keyClick(&view, Qt::Key_Home);
  EXPECT_EQ(pixelsThatDiffer(first, pictureOf(view)), 0);
  // Round and back: 72 steps of five degrees.
  for (int i = 0; i < 72; ++i) QTest::keyClick(&view, Qt::Key_Left);
  EXPECT_LT(pixelsThatDiffer(first, pictureOf(view)), 20);
}

TEST(SolidView, ThePoseChangesTheBody) {
  for (const auto& [id, pose] : {std::pair("nasogastric-tube", study::ItemCondition{"neck_flexion", "large"}),
                                 std::pair("male-urethral-catheter", study::ItemCondition{"angle", "upright"})}) {
    SolidView view(nullptr);
    view.resize(900, 300);
    view.setAbout(procedure::builtIn(id));
    const QImage usual = pictureOf(view);
    view.setPose(pose);
    EXPECT_GT(pixelsThatDiffer(usual, pictureOf(view)), 3000) << id;
    view.setPose({});
    EXPECT_EQ(pixelsThatDiffer(usual, pictureOf(view)), 0) << id;
  }
}

// For whoever changes the drawing: what a frame takes. Wanted are less than 16 ms for each.
TEST(SolidView, WhatAFrameTakes) {
  for (const QSize& size : {QSize(1280, 720), QSize(2560, 1440)}) {
    QImage screen(size, QImage::Format_RGB32);
    screen.fill(Qt::magenta);
    SolidView view(nullptr);
    view.resize(size);
    view.setAbout(procedure::defaultProcedure());
    const auto measure = [&](int frames, const auto& change) {
      QElapsedTimer timer;
      timer.start();
      for (int i = 0; i < frames; ++i) {
        change(i);
        view.render(&screen);
      }
      return static_cast<double>(timer.nsecsElapsed()) / 1e6 / frames;
    };
    constexpr int kFrames = 20;
    const double first_ms = measure(1, [](int) {});
    const double depth_ms = measure(kFrames, [&](int i) { view.setDepth(10 * i); });
    const double turn_ms = measure(kFrames, [&](int) { QTest::keyClick(&view, Qt::Key_Right); });
    const double lit_ms = measure(kFrames, [&](int i) { view.light(LitRange{10.0 * i, 10.0 * i + 60, {}}); });
    std::cout << size.width() << "x" << size.height() << ": first " << first_ms << " ms, another depth " << depth_ms
              << " ms, turned " << turn_ms << " ms, another region " << lit_ms << " ms\n";
    EXPECT_NE(screen.pixelColor(size.width() / 2, 0), QColor(Qt::magenta));
  }
}

}  // namespace
}  // namespace tactus::workbench::anatomy
