#include "app/workbench/shell/view_menu.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <optional>
#include <utility>

#include "app/workbench/base/theme.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel_area.h"

namespace tactus::workbench {

ViewMenu::ViewMenu(MainWindow& window, const ModelController& models, QSettings& settings)
    : window_(window), settings_(settings) {
  addStages();
  QAction* const panels = addPanels()->menuAction();
  addLooks();
  addTextSizes();
  QAction* const next =
      window_.menus().addAction(MenuSlot::kView, tr("Go to the next p&art of the window"), Qt::Key_F6);
  QAction* const before =
      window_.menus().addAction(MenuSlot::kView, tr("Go to the part &before"), Qt::SHIFT | Qt::Key_F6);
  connect(next, &QAction::triggered, &window_, [this] { window_.focusNextPart(true); });
  connect(before, &QAction::triggered, &window_, [this] { window_.focusNextPart(false); });
  QAction* const reset =
      window_.menus().addAction(MenuSlot::kView, tr("&Reset layout"), Qt::CTRL | Qt::SHIFT | Qt::Key_R);
  connect(reset, &QAction::triggered, &window_.panels(), &PanelArea::resetLayout);
  for (QAction* action : {panels, reset}) {
    action->setEnabled(false);
    connect(&models, &ModelController::opened, action, [action] { action->setEnabled(true); });
  }
}

void ViewMenu::addStages() {
  QMenu* menu = window_.menus().addMenu(MenuSlot::kView, tr("&Stage"));
  int number = 0;
  for (const Stage stage : kStages) {
    QAction* action = menu->addAction(stageName(stage));
    action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + number++)));
    action->setVisible(window_.hasScreen(stage));
    connect(action, &QAction::triggered, &window_, [this, stage] {
      if (window_.canEnter(stage)) return window_.enter(stage);
      window_.say(stage == Stage::kCollect || stage == Stage::kBuild ? tr("%1 needs a study.").arg(stageName(stage))
                                                                     : tr("%1 needs a model.").arg(stageName(stage)));
    });
  }
}

QMenu* ViewMenu::addPanels() {
  QMenu* menu = window_.menus().addMenu(MenuSlot::kView, tr("&Panels"));
  menu->addActions(window_.panels().toggleActions());
  return menu;
}

void ViewMenu::addLooks() {
  QMenu* menu = window_.menus().addMenu(MenuSlot::kView, tr("&Look"));
  auto* group = new QActionGroup(menu);
  const std::pair<std::optional<theme::Look>, QString> looks[] = {
      {std::nullopt, tr("As the s&ystem")}, {theme::Look::kLight, tr("&Light")}, {theme::Look::kDark, tr("&Dark")}};
  const auto now = appearance::chosenLook(settings_);
  for (const auto& [look, name] : looks) {
    QAction* action = menu->addAction(name);
    action->setCheckable(true);
    action->setChecked(look == now);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, chosen = look] {
      appearance::chooseLook(settings_, chosen);
      theme::changeLook(*qApp, chosen.value_or(appearance::systemLook(*qApp)));
    });
  }
}

void ViewMenu::addTextSizes() {
  QMenu* menu = window_.menus().addMenu(MenuSlot::kView, tr("&Text size"));
  auto* group = new QActionGroup(menu);
  for (const int percent : appearance::kTextSizes) {
    QAction* action = menu->addAction(tr("%1 %").arg(percent));
    action->setCheckable(true);
    action->setChecked(percent == appearance::chosenTextSize(settings_));
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, percent] {
      appearance::chooseTextSize(settings_, percent);
      appearance::changeTextSize(*qApp, percent);
    });
  }
}

}  // namespace tactus::workbench
