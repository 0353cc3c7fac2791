// The strip at the bottom: the operating point as numbers to edit, the last message, and the state of device and file.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QHBoxLayout;
class QLabel;
class QTimer;

namespace tactus::workbench {

class ElidedLabel;
class ModelController;
class NumberBox;
class SceneController;

class OperatingStrip : public QWidget {
  Q_OBJECT

 public:
  OperatingStrip(const ModelController& models, SceneController& scene, QWidget* parent = nullptr);

  /// A widget for the state of something that runs: the device, the live link. They stand between the operating point
  /// and the latency, in the order of the calls.
  void addState(QWidget* state);
  /// The widget for the time from an edit to the screen; stands beside the latency, where there is room for it.
  void setFrameTime(QWidget* time);
  /// The widget in the corner: what must be found without looking for it.
  void setCorner(QWidget* corner);
  /// Shows the time from the last edit to the force; empty while no model is felt.
  void showLatency(const QString& latency);
  /// Shows where edits are stored if not in a file, in words; empty: shows the state of the file. `bad`: storing fails
  /// at the moment.
  void showStored(const QString& stored, bool bad);
  /// Whether the operating point is shown: it is of no use where no model is.
  void showPoint(bool shown);
  /// Shows one sentence, long enough to read it. The layout of the window does not change.
  void showMessage(const QString& sentence);
  const QString& message() const { return message_; }

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void build();
  void makeRoom();
  void nameInputs();
  void showValue(std::size_t input);
  void showSaved();

  const ModelController& models_;
  SceneController& scene_;
  QHBoxLayout* layout_;
  QWidget* point_;
  ElidedLabel* said_;
  QLabel* latency_;
  QLabel* saved_;
  QWidget* frame_time_ = nullptr;
  QTimer* message_time_;
  QString message_;
  std::vector<QLabel*> names_;
  QString stored_;
  bool stored_bad_ = false;
  bool point_shown_ = true;
  std::vector<NumberBox*> numbers_;
};

}  // namespace tactus::workbench
