// The list of all shortcuts: those of the menus, read from their actions, and the mouse and key functions of plots.
#pragma once

#include <QDialog>

class QMenuBar;

namespace tactus::workbench {

class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  explicit ShortcutSheet(const QMenuBar& menus, QWidget* parent = nullptr);
};

}  // namespace tactus::workbench
