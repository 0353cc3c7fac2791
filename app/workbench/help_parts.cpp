#include "app/workbench/help_parts.h"

#include <QAction>
#include <utility>

#include "app/workbench/help/guide_window.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/start_parts.h"

namespace tactus::workbench {

HelpParts::HelpParts(MainWindow& window, const ModelController& models, StartParts& start, const ToldPanels& panels)
    : window_(window), models_(models), start_(start), guide_(new GuideWindow(&window)), tour_(window, steps(panels)) {
  WindowMenus& menus = window_.menus();
  QAction* const guide = menus.addAction(MenuSlot::kHelp, tr("Read the &guide"), QKeySequence(Qt::Key_F1));
  QAction* const tour = menus.addAction(MenuSlot::kHelp, tr("Take the five-minute &tour"));
  connect(guide, &QAction::triggered, guide_, &GuideWindow::open);
  connect(tour, &QAction::triggered, this, &HelpParts::startTour);
  connect(&start_, &StartParts::guideRequested, guide_, &GuideWindow::open);
  connect(&start_, &StartParts::tourRequested, this, &HelpParts::startTour);
  connect(&start_, &StartParts::demoShown, this, [this] {
    if (std::exchange(tour_waits_, false)) tour_.start();
  });
  connect(&window_, &MainWindow::closing, &tour_, &Tour::end);
}

void HelpParts::startTour() {
  tour_waits_ = models_.current() == nullptr;
  if (tour_waits_) {
    start_.exploreDemo();
  } else {
    tour_.start();
  }
}

std::vector<TourStep> HelpParts::steps(const ToldPanels& panels) {
  const auto at = [this](Stage stage, Panel& panel) {
    return [this, stage, &panel]() -> QWidget* {
      window_.enter(stage);
      panel.reveal();
      return &panel;
    };
  };
  const auto strip = [this]() -> QWidget* {
    window_.enter(Stage::kUnderstand);
    return &window_.strip();
  };
  return {
      {tr("The force on the way of the tube"),
       tr("Each thin line is one nurse, the thick one is their mean. Move the mouse over the curves to read them; turn "
          "the wheel to come closer. A gap is a place for which no nurse gave a rule."),
       at(Stage::kUnderstand, panels.curves)},
      {tr("One place for everything"),
       tr("Lubrication, neck, depth and speed: this is the situation that all panels speak of. Type a number, or click "
          "into the curves."),
       strip},
      {tr("Why this force"),
       tr("The rules that speak at this place, the strongest first, and what each of them pulls the force to."),
       at(Stage::kUnderstand, panels.rules_here)},
      {tr("The whole picture"),
       tr("The force for every depth and speed at once. Sharp edges are places where one word ends and the next "
          "begins."),
       at(Stage::kUnderstand, panels.map)},
      {tr("Change what a word means"),
       tr("Drag a corner: the curves follow while you drag. Ctrl+Z takes everything back, and the history keeps every "
          "state."),
       at(Stage::kTune, panels.membership_editor)},
      {tr("What to look at first"),
       tr("Holes, contradictions and jumps of the force, largest first. Where a repair is plain, one click does it."),
       at(Stage::kTune, panels.findings)},
      {tr("Feel it"),
       tr("Press Start (F9), hold Space and move the mouse over the pad: the tube resists as the model says. No device "
          "is needed. F12 or Esc takes the force away; F10 makes this the whole window."),
       at(Stage::kTune, panels.feel)},
      {tr("Hand it to a simulator"),
       tr("What is missing before the model can be delivered, and the bundle for the people who build the simulator. "
          "The guide (F1) tells the rest."),
       at(Stage::kDeliver, panels.readiness)}};
}

}  // namespace tactus::workbench
