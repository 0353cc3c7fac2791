// Whose force a map or surface shows, and over which two inputs: three boxes in the head of each panel that shows it.
#pragma once

#include <QWidget>

class QComboBox;

namespace tactus::workbench {

class ForceMapController;
class SceneController;

/// All choices of one controller show the same; what is chosen in one holds for all. While it is on the screen, its
/// panel counts as a viewer of the map.
class MapChoice : public QWidget {
  Q_OBJECT

 public:
  MapChoice(const SceneController& scene, ForceMapController& map, QWidget* parent = nullptr);

  /// Whose force it is, as it is written: `Mean`.
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
