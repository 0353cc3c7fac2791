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

/// Until nothing in `window` is to be done any more and its picture stays the same.
inline void settle(QWidget& window) {
  QImage last;
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        if (!isQuiet(window)) return false;
        const QImage now = window.grab().toImage();
        return std::exchange(last, now) == now;
      },
      kPatience));
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
