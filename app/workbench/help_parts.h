// Adds the guide and the tour to the window: the first actions of the menu Help, and their buttons on the start screen.
#pragma once

#include <QObject>
#include <vector>

#include "app/workbench/help/tour.h"

namespace tactus::workbench {

class GuideWindow;
class MainWindow;
class ModelController;
class Panel;
class StartParts;

/// The panels of which the tour speaks.
struct ToldPanels {
  Panel& curves;
  Panel& map;
  Panel& rules_here;
  Panel& membership_editor;
  Panel& findings;
  Panel& feel;
  Panel& readiness;
};

class HelpParts : public QObject {
  Q_OBJECT

 public:
  HelpParts(MainWindow& window, const ModelController& models, StartParts& start, const ToldPanels& panels);

  GuideWindow& guide() { return *guide_; }
  Tour& tour() { return tour_; }

 public slots:
  /// Without a model the demo study is opened before.
  void startTour();

 private:
  std::vector<TourStep> steps(const ToldPanels& panels);

  MainWindow& window_;
  const ModelController& models_;
  StartParts& start_;
  GuideWindow* guide_;
  Tour tour_;
  bool tour_waits_ = false;  ///< for the demo study
};

}  // namespace tactus::workbench
