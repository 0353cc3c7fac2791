// The boxes in the header of a map or surface panel: the expert (or mean) and the two inputs.
#pragma once

#include <QWidget>

class QComboBox;

namespace tactus::workbench {

class ForceMapController;
class SceneController;

/// All instances of one controller show the same choice. A visible instance counts its panel as a viewer of the map.
class MapChoice : public QWidget {
  Q_OBJECT

 public:
  MapChoice(const SceneController& scene, ForceMapController& map, QWidget* parent = nullptr);

  /// The owner of the force, as shown: `Mean`.
  QString who() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void adoptModel();
  void showChoice();

  const SceneController& scene_;
  ForceMapController& map_;
  QComboBox* who_;
  QComboBox* x_input_;
  QComboBox* y_input_;
  bool counted_ = false;
};

}  // namespace tactus::workbench
