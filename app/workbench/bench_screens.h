// The stages that show the open model, and the places of their panels before the user moves them.
#pragma once

namespace tactus::workbench {

class MainWindow;
class Panel;

struct BenchPanels {
  Panel& terms_here;
  Panel& rules_here;
  Panel& curves;
  Panel& reading;
  Panel& map;
  Panel& surface;
  Panel& feel;
  Panel& membership_editor;
  Panel& rule_editor;
  Panel& findings;
  Panel& history;
  Panel& readiness;
  Panel& bundle;
};

class BenchScreens {
 public:
  BenchScreens(MainWindow& window, const BenchPanels& panels);
};

}  // namespace tactus::workbench
