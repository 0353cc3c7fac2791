// Adds "Serve to a simulator" to the window: the menu entry, its dialog, the sign in the strip, and what the hand feels
// for the simulators.
#pragma once

#include <QObject>

#include "app/workbench/felt_states.h"

class QAction;

namespace tactus::workbench {

class LinkController;
class LinkDialog;
class MainWindow;
class ModelController;

class LinkParts : public QObject {
  Q_OBJECT

 public:
  LinkParts(MainWindow& window, const ModelController& models, const SceneController& scene, FeelController& feel,
            LinkController& link);

  LinkDialog& dialog() { return *dialog_; }
  void showDialog();

 private:
  void showFelt();

  MainWindow& window_;
  FeelController& feel_;
  LinkController& link_;
  FeltStates states_;
  LinkDialog* dialog_;
  QAction* serve_;
  bool felt_ = false;     ///< a run is in progress
  bool serving_ = false;  ///< as last said
};

}  // namespace tactus::workbench
