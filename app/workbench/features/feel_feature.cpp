#include <QAction>
#include <QCoreApplication>
#include <QSettings>

#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/feel_status.h"
#include "app/workbench/shell/operating_strip.h"

namespace tactus::workbench {

namespace {

struct FeelFeature {
  Q_DECLARE_TR_FUNCTIONS(FeelFeature)
};

}  // namespace

void addFeel(Bench& bench) {
  FeelController& feel = bench.feel;
  MainWindow& window = bench.window;
  auto* view = new FeelPanel(bench.scene, feel);
  bench.views.feel = view;
  bench.panels.feel = &window.addPanel(QStringLiteral("feel"), FeelFeature::tr("Feel"), view);
  auto* off = new ForceOffButton;
  auto* status = new FeelStatus(feel);
  window.strip().addState(status);
  window.strip().setCorner(off);
  QObject::connect(off, &ForceOffButton::pressed, &feel, &FeelController::stop);
  QObject::connect(status, &FeelStatus::latencyChanged, &window.strip(), &OperatingStrip::showLatency);
  // Without the window the user cannot stop the force.
  QObject::connect(&window, &MainWindow::closing, &feel, &FeelController::stop);
  WindowMenus& menus = window.menus();
  QAction* const start =
      menus.addAction(MenuSlot::kFeelDevice, FeelFeature::tr("&Start on the chosen device"), Qt::Key_F9);
  // Works without the menu too, whatever has the keyboard (feel_panel.cpp).
  QAction* const stop = menus.addAction(MenuSlot::kFeelDevice, FeelFeature::tr("S&top: no force"), Qt::Key_F12);
  QAction* const pose =
      menus.addAction(MenuSlot::kFeelPatient, FeelFeature::tr("Switch the &pose of the patient"), Qt::Key_F8);
  QAction* const new_placement = menus.addAction(MenuSlot::kFeelPatient, FeelFeature::tr("&New placement"));
  QAction* const layout = menus.addAction(MenuSlot::kFeelDevice, FeelFeature::tr("Show the Feel &layout"), Qt::Key_F10);
  layout->setCheckable(true);
  QObject::connect(layout, &QAction::triggered, &window, [&window](bool on) {
    if (on) {
      window.enterLayout(feelLayout());
    } else {
      window.leaveLayout();
    }
  });
  QObject::connect(&window, &MainWindow::layoutChanged, layout, [&window, &feel, layout] {
    const bool feels = window.layoutBeside() == feelLayout();
    layout->setChecked(feels);
    if (feels) feel.restPoseAtFirst();
  });
  QAction* const solid = menus.addAction(MenuSlot::kFeelPatient, FeelFeature::tr("Show the body in &3-D"), Qt::Key_F4);
  solid->setCheckable(true);
  const QString solid_setting = QStringLiteral("feel/solid");
  QObject::connect(solid, &QAction::toggled, view, &FeelPanel::setSolid);
  QObject::connect(view, &FeelPanel::solidChanged, solid, [&settings = bench.settings, solid, solid_setting](bool on) {
    solid->setChecked(on);
    settings.setValue(solid_setting, on);
  });
  solid->setChecked(bench.settings.value(solid_setting, false).toBool());
  QObject::connect(view, &FeelPanel::largeAsked, layout, &QAction::trigger);
  QObject::connect(start, &QAction::triggered, view, &FeelPanel::toggle);
  QObject::connect(stop, &QAction::triggered, &feel, &FeelController::stop);
  QObject::connect(pose, &QAction::triggered, &feel, [&feel] { feel.setPosed(!feel.isPosed()); });
  QObject::connect(new_placement, &QAction::triggered, &feel, &FeelController::newPlacement);
  const auto show_actions = [&models = bench.models, &scene = bench.scene, &feel, off, start, stop, pose, new_placement,
                             layout] {
    const bool open = models.current() != nullptr;
    const bool in_use = feel.isRunning() || feel.state() == FeelController::State::kOpening;
    start->setEnabled(open && feel.state() == FeelController::State::kStopped);
    stop->setEnabled(in_use);
    off->setVisible(in_use);
    layout->setEnabled(open);
    pose->setEnabled(open && posedInput(scene.procedure().get(), models.current()->model));
    new_placement->setEnabled(feel.isRunning());
  };
  QObject::connect(&feel, &FeelController::stateChanged, &bench.features, show_actions);
  QObject::connect(&bench.models, &ModelController::opened, &bench.features, show_actions);
  QObject::connect(&bench.scene, &SceneController::modelChanged, &bench.features, show_actions);
  QObject::connect(&bench.scene, &SceneController::procedureChanged, &bench.features, show_actions);
  show_actions();
}

}  // namespace tactus::workbench
