// Adds feeling the model to the window: its panel, the menu Feel, and the state of the device in the strip.
#pragma once

#include <QObject>
#include <QString>

class QAction;

namespace tactus::workbench {

class FeelController;
class ForceOffButton;
class FeelPanel;
class MainWindow;
class ModelController;
class Panel;
class SceneController;

class FeelParts : public QObject {
  Q_OBJECT

 public:
  FeelParts(MainWindow& window, const ModelController& models, SceneController& scene, FeelController& feel);

  /// The name of the layout for feeling alone.
  static QString layoutId() { return QStringLiteral("feel"); }

  FeelPanel& view() { return *view_; }
  Panel& panel() { return *panel_; }

 private:
  void buildMenu();
  void showActions();

  MainWindow& window_;
  const ModelController& models_;
  FeelController& feel_;
  FeelPanel* view_;
  Panel* panel_;
  ForceOffButton* off_;
  QAction* start_ = nullptr;
  QAction* layout_ = nullptr;
  QAction* stop_ = nullptr;
  QAction* flex_ = nullptr;
  QAction* new_placement_ = nullptr;
};

}  // namespace tactus::workbench
