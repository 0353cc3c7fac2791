#include "app/workbench/shell/window_menus.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>

namespace tactus::workbench {
namespace {

struct MenuText {
  Q_DECLARE_TR_FUNCTIONS(MenuText)
};

/// A menu holds the slots up to and with `last`, from the one after the menu before.
struct MenuSpan {
  MenuSlot last;
  QString title;
};

QList<MenuSpan> spans() {
  return {{MenuSlot::kFileQuit, MenuText::tr("&File")},    {MenuSlot::kEditAuthor, MenuText::tr("&Edit")},
          {MenuSlot::kStudyNotes, MenuText::tr("&Study")}, {MenuSlot::kView, MenuText::tr("&View")},
          {MenuSlot::kFeelLink, MenuText::tr("Fee&l")},    {MenuSlot::kHelp, MenuText::tr("&Help")}};
}

}  // namespace

WindowMenus::WindowMenus(QMenuBar& bar) {
  int slot = 0;
  for (const MenuSpan& span : spans()) {
    QMenu* menu = bar.addMenu(span.title);
    menu->menuAction()->setVisible(false);
    // A menu shows no separator at its end, and one for several in a row.
    for (; slot <= static_cast<int>(span.last); ++slot) groups_.push_back({menu, menu->addSeparator()});
  }
}

const WindowMenus::Group& WindowMenus::group(MenuSlot slot) const { return groups_[static_cast<std::size_t>(slot)]; }

QMenu& WindowMenus::menu(MenuSlot slot) const { return *group(slot).menu; }

QAction* WindowMenus::addAction(MenuSlot slot, const QString& text, const QKeySequence& keys) {
  auto* action = new QAction(text, group(slot).menu);
  action->setShortcut(keys);
  insert(slot, action);
  return action;
}

QMenu* WindowMenus::addMenu(MenuSlot slot, const QString& title) {
  auto* submenu = new QMenu(title, group(slot).menu);
  insert(slot, submenu->menuAction());
  return submenu;
}

void WindowMenus::insert(MenuSlot slot, QAction* action) {
  const auto [menu, end] = group(slot);
  menu->insertAction(end, action);
  menu->menuAction()->setVisible(true);
}

}  // namespace tactus::workbench
