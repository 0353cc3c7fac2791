// The panel for feeling the open model: device, hand, patient, force and placement. It only arranges its parts.
#pragma once

#include <QList>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/anatomy/anatomy.h"
#include "app/workbench/anatomy/anatomy_view.h"
#include "app/workbench/feel/procedure.h"
#include "core/fuzzy/force_model.h"
#include "core/haptics/device/device.h"

class QBoxLayout;
class QCheckBox;
class QLabel;

namespace tactus::workbench {

// The anatomy picture of the bench: the tube at its depth, and the region of the model in which its tip is lit. The
// regions are those of the model's depth terms, not of anatomy.

/// How the neck is drawn at `value` of its flexion: the first word upright, the last chin on chest, those between half
/// flexed.
anatomy::Posture drawnPosture(const fuzzy::Variable& neck_flexion, double value);

class TubePicture : public anatomy::AnatomyView {
  Q_OBJECT

 public:
  explicit TubePicture(QWidget* parent = nullptr);

  void setRegions(std::vector<DepthRegion> regions);
  /// Depth of the tip, mm.
  void setTip(double depth_mm);
  /// The region of the tip; empty in front of the nose and outside all regions.
  QString regionText() const;
  /// Moves the head within one second, as the force changes; at once the first time.
  void setNeck(anatomy::Posture posture);

 private:
  void showTip();

  std::vector<DepthRegion> regions_;
  double depth_mm_ = 0;
  bool placed_ = false;  ///< the neck has a posture
};

class DeviceBar;
class DeviceSearch;
class DrawerButton;
class ElidedLabel;
class FeelController;
class FeelKeys;
class ForceBar;
class ForceTracePlot;
class PatientControls;
class PlacementCard;
class ProcedurePanel;
class TubePicture;
class SceneController;
class TubePad;

class FeelPanel : public QWidget {
  Q_OBJECT

 public:
  FeelPanel(SceneController& scene, FeelController& feel, QWidget* parent = nullptr);
  ~FeelPanel() override;

  /// Adds a card below the others; in a low panel a button with this name opens it.
  void addCard(const QString& name, QWidget* card);
  /// Starts on the chosen device, or stops it.
  void toggle();
  /// Shows on the pad that a recording waits for the next start (`armed`), or is in progress with this length, s.
  void showRecording(bool armed, std::optional<int> recorded_s);
  /// Whether the panel has space for more than the necessary parts.
  bool isRoomy() const { return roomy_; }

 signals:
  void roomChanged(bool roomy);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void build();
  void arrange();
  void setOpen(bool open);
  void setLow(bool low);
  void showLegend();
  void connectAll();
  void adoptModel();
  void showRegions();
  void showNeck();
  void showState();
  void showFelt();
  void showForce();
  QString limitText() const;

  SceneController& scene_;
  FeelController& feel_;
  FeelKeys* keys_;
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
  bool open_ = false;  ///< the panel is the whole window
  bool low_ = false;   ///< the panel has no height for more than the hand and the picture
  bool armed_ = false;
  std::optional<int> recorded_s_;
  std::optional<haptics::DeviceInfo> traced_on_;  ///< the device of the trace
  TubePicture* tube_;
  ProcedurePanel* procedure_;
  PlacementCard* placement_;
  QBoxLayout* halves_ = nullptr;  ///< hand and patient
  QBoxLayout* hand_ = nullptr;
  QBoxLayout* picture_ = nullptr;  ///< path of the tube and procedure
  QBoxLayout* cards_ = nullptr;    ///< top to bottom
  QBoxLayout* foot_ = nullptr;     ///< below the path of the tube
  QList<DrawerButton*> drawers_;
  std::optional<fuzzy::Variable> depth_;  ///< the variable whose regions are visible
  bool trace_due_ = false;                ///< the trace is drawn at every second beat
};

}  // namespace tactus::workbench
