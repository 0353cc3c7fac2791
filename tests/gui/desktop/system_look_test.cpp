#include "app/workbench/desktop/system_look.h"

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

class SystemLookTest : public testing::Test {
 protected:
  const QTemporaryDir folder;
  QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
};

TEST_F(SystemLookTest, TheDesktopChangesTheLookWhileTheProgramRunsUnlessOneIsChosen) {
  SystemLook system;
  QObject::connect(&system, &SystemLook::changed, qApp,
                   [this](theme::Look look) { appearance::followSystem(*qApp, settings, look); });
  const QString group = QStringLiteral("org.freedesktop.appearance");
  const QString key = QStringLiteral("color-scheme");
  // As the portal's signal brings it, and as its answer does: in one variant more.
  system.onSetting(group, key, QDBusVariant(1U));
  EXPECT_TRUE(theme::isDark());
  system.onSetting(group, key, QDBusVariant(QVariant::fromValue(QDBusVariant(2U))));
  EXPECT_FALSE(theme::isDark());
  system.onSetting(group, QStringLiteral("contrast"), QDBusVariant(1U));
  system.onSetting(group, key, QDBusVariant(0U));  // no wish
  EXPECT_FALSE(theme::isDark());
  appearance::chooseLook(settings, theme::Look::kLight);
  system.onSetting(group, key, QDBusVariant(1U));
  EXPECT_FALSE(theme::isDark());
  EXPECT_EQ(appearance::systemLook(*qApp), theme::Look::kDark);
  system.onSetting(group, key, QDBusVariant(2U));
}

}  // namespace
}  // namespace tactus::workbench
