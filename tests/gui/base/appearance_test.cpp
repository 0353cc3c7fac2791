#include <QApplication>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

class AppearanceTest : public testing::Test {
 protected:
  const QTemporaryDir folder;
  QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
};

TEST_F(AppearanceTest, FollowsTheSystemUntilALookIsChosen) {
  EXPECT_FALSE(appearance::chosenLook(settings));
  appearance::chooseLook(settings, theme::Look::kDark);
  EXPECT_EQ(appearance::chosenLook(settings), theme::Look::kDark);
  appearance::chooseLook(settings, theme::Look::kLight);
  EXPECT_EQ(appearance::chosenLook(settings), theme::Look::kLight);
  appearance::chooseLook(settings, std::nullopt);
  EXPECT_FALSE(appearance::chosenLook(settings));
}

TEST_F(AppearanceTest, AnOddTextSizeIsTheSystems) {
  EXPECT_EQ(appearance::chosenTextSize(settings), 100);
  appearance::chooseTextSize(settings, 150);
  EXPECT_EQ(appearance::chosenTextSize(settings), 150);
  appearance::chooseTextSize(settings, 1000);
  EXPECT_EQ(appearance::chosenTextSize(settings), 100);
}

TEST_F(AppearanceTest, AllTextsGrowAndShrinkTogether) {
  QLabel large;
  large.setFont(theme::titleFont());
  const double plain_points = QApplication::font().pointSizeF();
  const double large_points = large.font().pointSizeF();
  appearance::changeTextSize(*qApp, 150);
  EXPECT_NEAR(QApplication::font().pointSizeF(), 1.5 * plain_points, 1e-9);
  EXPECT_NEAR(large.font().pointSizeF(), 1.5 * large_points, 1e-9);
  EXPECT_NEAR(theme::titleFont().pointSizeF() - QApplication::font().pointSizeF(), 3, 1e-9);
  appearance::changeTextSize(*qApp, 100);
  EXPECT_NEAR(QApplication::font().pointSizeF(), plain_points, 1e-9);
  EXPECT_NEAR(large.font().pointSizeF(), large_points, 1e-9);
}

}  // namespace
}  // namespace tactus::workbench
