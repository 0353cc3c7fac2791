// The strip at the bottom: the operating point as numbers that can be typed, what was said last, and the state of
// things.
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

  /// A place for the state of the device, between the operating point and the latency.
  void setDeviceState(QWidget* state);
  /// A place for how long the last edit took until it was seen, beside the latency.
  void setFrameTime(QWidget* time);
  /// How long the last edit took until it was felt, or nothing while nothing is felt.
  void showLatency(const QString& latency);
  /// Where edits are kept instead of in a file, with a word about it; empty: the file's state is shown. `bad`: they are
  /// not kept now.
  void showStored(const QString& stored, bool bad);
  /// One sentence, for as long as it takes to read it. Nothing in the window moves for it.
  void showMessage(const QString& sentence);
  const QString& message() const { return message_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void build();
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
  QTimer* message_time_;
  QString message_;
  std::vector<QLabel*> names_;
  QString stored_;
  bool stored_bad_ = false;
  std::vector<NumberBox*> numbers_;
};

}  // namespace tactus::workbench
