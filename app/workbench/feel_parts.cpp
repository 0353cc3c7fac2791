#include "app/workbench/feel_parts.h"

#include <QAction>

#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/feel_status.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/operating_strip.h"

namespace tactus::workbench {

FeelParts::FeelParts(MainWindow& window, const ModelController& models, SceneController& scene, FeelController& feel)
    : window_(window),
      models_(models),
      feel_(feel),
      view_(new FeelPanel(scene, feel)),
      panel_(&window.addPanel(QStringLiteral("feel"), tr("Feel"), view_)),
      off_(new ForceOffButton) {
  auto* status = new FeelStatus(feel);
  window_.strip().addState(status);
  window_.strip().setCorner(off_);
  connect(off_, &ForceOffButton::pressed, &feel_, &FeelController::stop);
  connect(status, &FeelStatus::latencyChanged, &window_.strip(), &OperatingStrip::showLatency);
  // Without the window the user cannot stop the force.
  connect(&window_, &MainWindow::closing, &feel_, &FeelController::stop);
  buildMenu();
  connect(&feel_, &FeelController::stateChanged, this, &FeelParts::showActions);
  connect(&models_, &ModelController::opened, this, &FeelParts::showActions);
  showActions();
}

void FeelParts::buildMenu() {
  WindowMenus& menus = window_.menus();
  start_ = menus.addAction(MenuSlot::kFeelDevice, tr("&Start on the chosen device"), Qt::Key_F9);
  // Works without the menu too, whatever has the keyboard (feel_panel.cpp).
  stop_ = menus.addAction(MenuSlot::kFeelDevice, tr("S&top: no force"), Qt::Key_F12);
  flex_ = menus.addAction(MenuSlot::kFeelPatient, tr("&Flex the neck, or raise the head"), Qt::Key_F8);
  new_placement_ = menus.addAction(MenuSlot::kFeelPatient, tr("&New placement"));
  layout_ = menus.addAction(MenuSlot::kFeelDevice, tr("Show the Feel &layout"), Qt::Key_F10);
  layout_->setCheckable(true);
  connect(layout_, &QAction::triggered, &window_, [this](bool on) {
    if (on) {
      window_.enterLayout(layoutId());
    } else {
      window_.leaveLayout();
    }
  });
  connect(&window_, &MainWindow::layoutChanged, layout_, [this] {
    const bool feels = window_.layoutBeside() == layoutId();
    layout_->setChecked(feels);
    if (feels) feel_.raiseHeadAtFirst();
  });
  connect(start_, &QAction::triggered, view_, &FeelPanel::toggle);
  connect(stop_, &QAction::triggered, &feel_, &FeelController::stop);
  connect(flex_, &QAction::triggered, &feel_, [this] { feel_.setNeckFlexed(!feel_.isNeckFlexed()); });
  connect(new_placement_, &QAction::triggered, &feel_, &FeelController::newPlacement);
}

void FeelParts::showActions() {
  const bool open = models_.current() != nullptr;
  start_->setEnabled(open && feel_.state() == FeelController::State::kStopped);
  stop_->setEnabled(feel_.isRunning() || feel_.state() == FeelController::State::kOpening);
  off_->setVisible(feel_.isRunning() || feel_.state() == FeelController::State::kOpening);
  layout_->setEnabled(open);
  flex_->setEnabled(open);
  new_placement_->setEnabled(feel_.isRunning());
}

}  // namespace tactus::workbench
