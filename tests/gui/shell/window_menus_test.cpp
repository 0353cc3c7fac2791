#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <gtest/gtest.h>

#include "app/workbench/shell/main_window.h"

namespace tactus::workbench {
namespace {

/// The titles of the menus that can be seen, each with its actions; a bar stands for the end of a group.
QString shown(const QMenuBar& bar) {
  QString out;
  for (const QAction* menu : bar.actions()) {
    if (!menu->isVisible()) continue;
    out += menu->text() + QLatin1Char(':');
    for (const QAction* action : menu->menu()->actions()) {
      out += action->isSeparator() ? QStringLiteral("|") : QLatin1Char(' ') + action->text();
    }
    out += QLatin1Char(';');
  }
  return out;
}

TEST(WindowMenus, KeepTheirOrderWhateverTheFeatures) {
  QMenuBar bar;
  WindowMenus menus(bar);
  EXPECT_EQ(shown(bar), QString());
  menus.addAction(MenuSlot::kFeelPatient, QStringLiteral("flex"));
  menus.addAction(MenuSlot::kFileQuit, QStringLiteral("quit"));
  menus.addAction(MenuSlot::kFeelDevice, QStringLiteral("start"));
  menus.addAction(MenuSlot::kFileOpen, QStringLiteral("open"));
  menus.addMenu(MenuSlot::kFileOpen, QStringLiteral("recent"));
  EXPECT_EQ(shown(bar), QStringLiteral("&File: open recent||| quit|;Fee&l: start| flex||;"));
}

TEST(WindowMenus, AnActionIsInTheMenuOfItsSlot) {
  QMenuBar bar;
  WindowMenus menus(bar);
  const QAction* undo = menus.addAction(MenuSlot::kEditUndo, QStringLiteral("undo"), Qt::CTRL | Qt::Key_Z);
  EXPECT_EQ(undo->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_Z));
  EXPECT_TRUE(menus.menu(MenuSlot::kEditAuthor).actions().contains(undo));
  EXPECT_FALSE(menus.menu(MenuSlot::kFileOpen).actions().contains(undo));
}

}  // namespace
}  // namespace tactus::workbench
