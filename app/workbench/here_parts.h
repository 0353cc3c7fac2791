// Adds to the window why the force is what it is at the place that is read: the terms and the rules there.
#pragma once

#include <QObject>

namespace tactus::workbench {

class MainWindow;
class Panel;
class SceneController;
class Selection;

class HereParts : public QObject {
  Q_OBJECT

 public:
  HereParts(MainWindow& window, SceneController& scene, Selection& selection);

  Panel& terms() { return terms_; }
  Panel& rules() { return rules_; }

 private:
  Panel& terms_;
  Panel& rules_;
};

}  // namespace tactus::workbench
