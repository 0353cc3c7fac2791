// The screens with the device: its check, strokes, forces, her own model.
#pragma once

#include <optional>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

// The device check: one thing to do with the handle, and a traffic light.

/// The id of the sentence that says how the tube is held on the device.
QString holdSentence(HoldMeans hold);

class DeviceCheckScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit DeviceCheckScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;

 private:
  TextBlock* texts_;
  Label* lead_;
  Label* hint_;
  PictureBox* picture_;
  Label* virtual_;
  TrafficLight* light_;
};

// Practice of strokes and the speed experiment: one word for the speed, the tube in the picture follows the hand, a dot
// for each stroke. Nothing moves by itself and nothing tells a speed.

class StrokeScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit StrokeScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;
  /// Where the hand is, mm from the start; drawn with the next frame.
  void setDepth(double depth_mm);

 private:
  TextBlock* texts_;
  Label* practice_;
  Label* lead_;
  Dots* dots_;
  PictureBox* tick_;
  Label* note_;
  anatomy::BodyView* picture_;
};

// Force perception: feel, then one of the words, then Confirm. Catch trials look the same. Nothing tells a force, a
// step or how many there are.

class ForceScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ForceScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;

 signals:
  void feelAgain();

 protected:
  /// From 1 the words, 0 not felt, 9 beyond practice, S would stop.
  QString idOfKey(int key) const override;
  /// F: feel again.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  ForceState state_;
  TextBlock* texts_;
  PictureBox* push_;
  Label* practice_;
  Label* lead_;
  Label* hint_;
  Choices* choices_;
  Button* stop_;  ///< whether she would stop at this force
  Button* feel_again_;
};

// Feel your own model, region by region: lighter, about the same, heavier than in practice, and "mark this moment". The
// researcher sees the marks; they change nothing by themselves.

class OwnModelScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit OwnModelScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;
  void setDepth(std::optional<double> depth_mm);

 signals:
  void marked();

 protected:
  /// 1 to 3: lighter, about the same, heavier.
  QString idOfKey(int key) const override;

 private:
  void show();

  OwnModelState state_;
  TextBlock* texts_;
  Label* region_;
  Label* do_;
  Label* line_;
  Button* mark_;
  Choices* choices_;
  anatomy::BodyView* picture_;
};

}  // namespace tactus::workbench::nurse
