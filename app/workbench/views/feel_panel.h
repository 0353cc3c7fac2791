// Feeling the open model: device, hand, patient, force and the placement. It only puts its parts together.
#pragma once

#include <QWidget>
#include <optional>

#include "core/fuzzy/force_model.h"
#include "core/haptics/device.h"

class QBoxLayout;
class QCheckBox;
class QLabel;

namespace tactus::workbench {

class DeviceBar;
class DeviceSearch;
class FeelController;
class ForceBar;
class ForceTracePlot;
class PatientControls;
class PlacementCard;
class ProcedurePanel;
class SagittalView;
class SceneController;
class TubePad;

class FeelPanel : public QWidget {
  Q_OBJECT

 public:
  FeelPanel(SceneController& scene, FeelController& feel, QWidget* parent = nullptr);
  ~FeelPanel() override;

  /// A further card below the trace.
  void addCard(QWidget* card);

 protected:
  /// Space holds the tube and Escape stops, wherever the keyboard is, while a model is felt.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void build();
  void connectAll();
  void adoptModel();
  void showRegions();
  void showState();
  void showFelt();
  void showForce();
  void showLegend();
  QString limitText() const;

  SceneController& scene_;
  FeelController& feel_;
  DeviceSearch* search_;
  DeviceBar* device_;
  PatientControls* patient_;
  TubePad* pad_;
  QLabel* force_;
  ForceBar* bar_;
  QLabel* limits_;
  QCheckBox* split_;
  QCheckBox* follow_;
  QLabel* legend_;
  ForceTracePlot* trace_;
  std::optional<haptics::DeviceInfo> traced_on_;  ///< what the trace was felt on
  SagittalView* sagittal_;
  ProcedurePanel* procedure_;
  PlacementCard* placement_;
  QBoxLayout* halves_ = nullptr;
  QBoxLayout* hand_half_ = nullptr;
  std::optional<fuzzy::Variable> depth_;  ///< whose regions are shown
  bool filtering_ = false;
  bool trace_due_ = false;  ///< the trace is drawn at every second beat
};

}  // namespace tactus::workbench
