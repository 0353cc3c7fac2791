// The menu bar. The menus and the groups in them have a fixed order, so that features may add their actions in any.
#pragma once

#include <QKeySequence>
#include <QString>
#include <vector>

class QAction;
class QMenu;
class QMenuBar;

namespace tactus::workbench {

/// A group of actions, between two separators of a menu. In the order on the screen: all groups of the first menu, then
/// those of the second.
enum class MenuSlot {
  kFileOpen,
  kFileSave,
  kFilePictures,
  kFileQuit,
  kEditUndo,
  kEditStates,
  kEditCompare,
  kEditAuthor,
  kStudyOpen,
  kStudyModel,
  kStudyClose,
  kStudyNotes,
  kView,
  kFeelDevice,
  kFeelPatient,
  kFeelLink,
  kHelp,
};

class WindowMenus {
 public:
  /// `bar` owns the menus.
  explicit WindowMenus(QMenuBar& bar);

  /// Adds an action at the end of `slot`. A menu is shown once it has an action.
  QAction* addAction(MenuSlot slot, const QString& text, const QKeySequence& keys = {});
  /// Adds a menu of its own at the end of `slot`.
  QMenu* addMenu(MenuSlot slot, const QString& title);
  /// The menu that holds `slot`.
  QMenu& menu(MenuSlot slot) const;

 private:
  struct Group {
    QMenu* menu;
    QAction* end;  ///< the separator behind its last action
  };
  const Group& group(MenuSlot slot) const;
  void insert(MenuSlot slot, QAction* action);

  std::vector<Group> groups_;  ///< one for each slot
};

}  // namespace tactus::workbench
