// The window of the workbench with a sample model, and waiting until it shows what it has to show.
#pragma once

#include <QSettings>
#include <QTest>
#include <gtest/gtest.h>
#include <utility>

#include "app/workbench/workbench.h"

#include "tests/gui/patience.h"
#include "tests/gui/quiet.h"
#include "tests/gui/sample_models.h"

namespace tactus::tests {

/// Where two pictures of a window differ.
inline QRect differenceOf(const QImage& one, const QImage& other) {
  if (one.size() != other.size()) return other.rect();
  QRect found;
  for (int y = 0; y < one.height(); ++y) {
    for (int x = 0; x < one.width(); ++x) {
      if (one.pixel(x, y) != other.pixel(x, y)) found |= QRect(x, y, 1, 1);
    }
  }
  return found;
}

/// Until nothing in `window` is to be done any more and its picture stays the same.
inline void settle(QWidget& window) {
  QImage last;
  QImage before_last;
  bool quiet = false;
  const bool settled = QTest::qWaitFor(
      [&] {
        quiet = isQuiet(window);
        if (!quiet) return false;
        const QImage now = window.grab().toImage();
        before_last = std::exchange(last, now);
        return before_last == now;
      },
      kPatience);
  const QRect changing = differenceOf(before_last, last);
  ASSERT_TRUE(settled) << (quiet ? std::string("the picture keeps changing in ")
                                 : whatIsLeft(window) + "last change in ")
                       << changing.x() << ' ' << changing.y() << ", " << changing.width() << " x " << changing.height();
}

class ShownBench : public testing::Test {
 protected:
  explicit ShownBench(workbench::Stage stage) : stage_(stage) {}

  void SetUp() override {
    show(bench);
    settle();
  }

  void show(workbench::Workbench& shown) {
    shown.window.resize(1280, 720);
    shown.window.show();
    shown.models.open(folder.write(twoExperts()));
    shown.window.enter(stage_);
  }

  void settle() { tests::settle(bench.window); }

  ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  workbench::Workbench bench{settings, folder.path(QStringLiteral("autosave"))};

 private:
  workbench::Stage stage_;
};

}  // namespace tactus::tests
