// Feeling the open model: device, hand, patient, force and the placement. It only puts its parts together.
#pragma once

#include <QWidget>
#include <optional>

#include "core/fuzzy/force_model.h"
#include "core/haptics/device/device.h"

class QBoxLayout;
class QCheckBox;
class QLabel;

namespace tactus::workbench {

class DeviceBar;
class DeviceSearch;
class ElidedLabel;
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

  /// A further card below everything else.
  void addCard(QWidget* card);
  /// Starts on the chosen device, or stops.
  void toggle();
  /// A recording waits for the next start, or is in progress and so long, s. The pad shows it.
  void showRecording(bool armed, std::optional<int> recorded_s);
  /// There is room for more than what is needed to feel.
  bool isRoomy() const { return roomy_; }

 signals:
  void roomChanged(bool roomy);

 protected:
  /// Space holds the tube and F12 stops, wherever the keyboard is, while a model is felt. Escape stops too, unless
  /// something is dragged: then it takes the drag back.
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void build();
  void arrange();
  void showLegend();
  bool escape(QObject& watched, QKeyEvent& key, bool asks);
  void connectAll();
  void adoptModel();
  void showRegions();
  void showState();
  void showFelt();
  void showForce();
  QString limitText() const;

  SceneController& scene_;
  FeelController& feel_;
  DeviceSearch* search_;
  DeviceBar* device_;
  PatientControls* patient_;
  TubePad* pad_;
  QLabel* force_;
  ForceBar* bar_;
  ElidedLabel* limits_;
  QCheckBox* split_;
  QCheckBox* follow_;
  QLabel* legend_;
  ForceTracePlot* trace_;
  bool roomy_ = false;
  bool armed_ = false;
  std::optional<int> recorded_s_;
  std::optional<haptics::DeviceInfo> traced_on_;  ///< what the trace was felt on
  SagittalView* sagittal_;
  ProcedurePanel* procedure_;
  PlacementCard* placement_;
  QBoxLayout* halves_ = nullptr;          ///< hand and patient
  QBoxLayout* picture_ = nullptr;         ///< way of the tube and procedure
  QBoxLayout* cards_ = nullptr;           ///< from top to bottom
  std::optional<fuzzy::Variable> depth_;  ///< whose regions are shown
  bool filtering_ = false;
  bool asking_ = false;        ///< the widget with the keyboard is asked whether it wants Escape
  bool escape_taken_ = false;  ///< it does
  bool trace_due_ = false;     ///< the trace is drawn at every second beat
};

}  // namespace tactus::workbench
