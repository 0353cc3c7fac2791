// The panel for feeling the open model: device, hand, patient, force and placement. It only arranges its parts.
#pragma once

#include <QList>
#include <QStringList>
#include <QVBoxLayout>
#include <QWidget>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/feel/placement.h"
#include "app/workbench/feel/procedure.h"
#include "app/workbench/plot/plot_menu.h"
#include "core/fuzzy/force_model.h"
#include "core/haptics/device/device.h"

class QBoxLayout;
class QCheckBox;
class QLabel;
class QComboBox;
class QPushButton;
class QToolButton;
class QCPGraph;
class QCustomPlot;
class QGridLayout;
class QPainter;

namespace tactus::workbench {

class Card;
class DeviceSearch;
class ElidedLabel;
class FeelController;
class NumberBox;
class SceneController;

// The pad on which the mouse is the hand: left and right moves the tube along its axis, the mouse button holds it. It
// shows how far the tube lags behind the cursor, which is how a virtual device shows a force.

class TubePad : public QWidget {
  Q_OBJECT

 public:
  explicit TubePad(QWidget* parent = nullptr);

  struct Reading {
    double hand_mm = 0;    ///< along the axis
    double tube_mm = 0;    ///< the point of the tube that the hand holds
    double target_mm = 0;  ///< target at the cursor
    bool live = false;     ///< mouse and keyboard drive the hand
    bool held = false;     ///< the hand holds the tube
    bool latch = false;    ///< a first press holds the tube, a second one releases it
    bool running = false;
    bool replay = false;            ///< a recording moves the tube
    bool armed = false;             ///< a recording waits for the next start
    std::optional<int> recorded_s;  ///< length of the current recording, s

    bool operator==(const Reading&) const = default;
  };
  void setReading(const Reading& reading);
  /// True: the hint is in the tool tip alone.
  void setLow(bool low);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

 signals:
  void targetMoved(double position_mm);
  void gripped(bool held);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  double xOf(double position_mm) const;
  double positionAt(double x) const;
  QString hint() const;
  void paintRecording(QPainter& painter) const;

  Reading reading_;
  bool pressed_ = false;  ///< with the mouse
  bool low_ = false;
};

// The steps of the procedure. The step for the current depth is highlighted.

// The placement in numbers: strokes and depth during it, and the summary of the last one.

class PlacementCard : public QWidget {
  Q_OBJECT

 public:
  explicit PlacementCard(QWidget* parent = nullptr);

  void setProgress(unsigned strokes, double depth_mm, const QString& region);
  void setSummary(const std::optional<PlacementSummary>& summary);
  /// Whether a run is in progress, so that another placement can begin.
  void setRunning(bool running);

 signals:
  void newPlacementRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QLabel* progress_;
  ElidedLabel* summary_;
  QPushButton* next_;
  QGridLayout* layout_ = nullptr;
  bool below_ = false;
  bool has_summary_ = false;  ///< of a finished placement
};

class ProcedurePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ProcedurePanel(QWidget* parent = nullptr);

  void setSteps(std::vector<ProcedureStep> steps);
  /// Depth of the tip, mm.
  void setDepth(double depth_mm);
  enum class Detail {
    kList,     ///< all steps, and the text of the current one
    kStep,     ///< the current step and its text
    kHeading,  ///< the name of the current step
  };
  void setDetail(Detail room);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Row {
    QLabel* number;
    QLabel* title;
  };
  void show(std::size_t step);
  void fitText();

  double depth_mm_ = 0;
  std::vector<ProcedureStep> steps_;
  std::vector<Row> rows_;
  QWidget* list_;
  ElidedLabel* head_;  ///< the current step, if the list is hidden
  QLabel* text_;
  std::optional<std::size_t> shown_;
  int lines_ = 0;  ///< that the text has room for
};

// The conditions that a nurse can change during the placement: the words of each, and one gesture for the pose.

class PatientControls : public QWidget {
  Q_OBJECT

 public:
  PatientControls(SceneController& scene, FeelController& feel, QWidget* parent = nullptr);

  /// In `room` px: each condition takes a row of its own where one row is too wide, and its name gives way where its
  /// words need the room.
  void fit(int room);
  /// The least room, px.
  int leastWidth() const;

 private:
  void build();
  void fitPose();
  void showValues();
  void onValue(std::size_t input);

  /// A condition with one button for each of its words.
  struct Row {
    std::size_t input;
    QWidget* holder;
    QLabel* name;
    QWidget* terms;
    std::vector<QPushButton*> buttons;
  };
  Row makeRowOf(std::size_t input);
  /// What the rows and the button show; they are made anew if it changes.
  QStringList wordsOf() const;

  SceneController& scene_;
  FeelController& feel_;
  std::vector<Row> conditions_;
  QStringList words_;
  QPushButton* pose_;
  QBoxLayout* rows_ = nullptr;
};

// The force on the hand as a bar on the scale of the trace, with the force cap of the servo.

// The force of the last ten seconds: the force on the hand, or its parts (fuzzy force, friction, limits). A replay also
// shows the recorded force. The wheel and Shift-drag choose the part of the time that is shown.

class AxisZoom;
class FeelHistory;
class ShownRanges;

class ForceTracePlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit ForceTracePlot(QWidget* parent = nullptr);

  /// Names the force axis after `output`. The axis ends at the upper end of the universe (> 0), or at a larger force.
  void setOutput(const fuzzy::Variable& output);
  /// Whether to show the parts of the force, too.
  void setSplit(bool split);
  bool isSplit() const { return split_; }
  /// The upper end of the force axis, N.
  double topN() const;
  /// Draws the last ten seconds; the newest point is at the right.
  void setHistory(const FeelHistory& history);

  QSize pictureSize() const override { return {1000, 360}; }
  /// Empty if the felt force is the only line.
  std::vector<LegendEntry> legend() const override;
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void nameAxes(bool roomy);
  fuzzy::Variable forceAxis() const;

  QCustomPlot* plot_;
  ShownRanges* ranges_;  ///< of the time, which no other plot has
  AxisZoom* zoom_;
  QCPGraph* force_;
  QCPGraph* recorded_;  ///< force of the replayed recording
  QCPGraph* friction_;
  QCPGraph* model_;
  QCPGraph* limits_;  ///< fills the area that the limits removed, between friction and force
  bool split_ = false;
  bool replays_ = false;  ///< a replay, with the recorded force beside it
  double full_n_ = 1;
  std::string force_name_;
};

class ForceBar : public QWidget {
  Q_OBJECT

 public:
  explicit ForceBar(QWidget* parent = nullptr);

  /// `force_n` fills the bar. A mark shows `friction_n`, the requested force, if the limits reduced it.
  void setForces(double force_n, double friction_n);
  /// Sets the end of the scale, > 0, and the largest force that the servo gives. A cap behind the end is only named.
  void setScale(double full_n, double cap_n);
  /// A higher bar, to be read from afar.
  void setLarge(bool large);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {100, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintScale(QPainter& painter, const QRectF& scale, const std::function<double(double)>& x_of) const;

  double force_n_ = 0;
  double friction_n_ = 0;
  double full_n_ = 2;
  double cap_n_ = 2;
  int bar_height_;  ///< px
};

// The controls of the device: the choice of the device, Start and Stop, the grip, and the state. A simulated device is
// labelled as such.

class DeviceBar : public QWidget {
  Q_OBJECT

 public:
  DeviceBar(FeelController& feel, DeviceSearch& search, QWidget* parent = nullptr);

  /// Whether a model is open and can be felt.
  void setModelOpen(bool open);
  /// True: after the start one chip stands for device and grip; a click on it shows them.
  void setFoldable(bool foldable);
  /// Shows `sentence` until the next start.
  void showFailure(const QString& sentence);
  /// Reads the values that change during a run: latency and rate.
  void showProgress();

 public slots:
  /// Starts on the chosen device, or stops it.
  void toggle();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void listDevices();
  void showState();
  void showMessage();
  void showChoice();
  void chooseGrip();
  QString stateText() const;
  QString stateWord() const;
  void fitLine();
  void fitMessage();
  void setMessage(const QString& sentence, bool bad);

  FeelController& feel_;
  DeviceSearch& search_;
  QComboBox* devices_;
  QToolButton* look_;
  QToolButton* chip_;  ///< in the place of the choice of device and grip
  QPushButton* start_;
  QComboBox* grip_;
  NumberBox* zone_;
  QLabel* simulated_;
  ElidedLabel* state_;
  Card* message_card_;
  QLabel* message_;
  QPushButton* rearm_;
  QPushButton* again_;  ///< starts once more after a failure
  QBoxLayout* line_ = nullptr;
  QString failure_;
  bool starting_ = false;  ///< by `toggle`, and not running yet
  bool model_open_ = false;
  bool foldable_ = false;
  bool advises_ = false;  ///< the message asks the user to push
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
  /// The body in three dimensions takes the place of its picture.
  void setSolid(bool on);

 signals:
  void solidChanged(bool on);
  void roomChanged(bool roomy);
  /// The user wants the panel as the whole window.
  void largeAsked();

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
  void adoptProcedure();
  void showRegions();
  void showPose();
  void showBody();
  void showSolid();
  void showTip(double depth_mm);
  /// The region of the tip; empty before the way and outside all regions.
  QString regionText(double depth_mm) const;
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
  QPushButton* large_;       ///< in a low panel, in place of the trace
  QWidget* copy_ = nullptr;  ///< of the trace
  QCheckBox* split_;
  QCheckBox* follow_;
  QLabel* legend_;
  ForceTracePlot* trace_;
  bool roomy_ = false;
  bool open_ = false;  ///< the panel is the whole window
  bool low_ = false;   ///< the panel has no height for more than the hand, the force and the picture
  bool armed_ = false;
  std::optional<int> recorded_s_;
  std::optional<haptics::DeviceInfo> traced_on_;  ///< the device of the trace
  anatomy::BodyView* body_ = nullptr;             ///< of the shown procedure; none for an unknown one
  bool posed_ = false;                            ///< it has a pose
  int least_picture_ = 0;                         ///< px, its least height
  QVBoxLayout* body_place_ = nullptr;
  QCheckBox* solid_box_;
  QLabel* solid_note_;  ///< why there is no 3-D view
  anatomy::SolidView* solid_;
  std::vector<DepthRegion> regions_;
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
