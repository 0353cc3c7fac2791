// The strip at the bottom: the operating point as numbers that can be typed, and the state of things.
#pragma once

#include <QWidget>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace tactus::workbench {

class ModelController;
class NumberBox;
class SceneController;

class OperatingStrip : public QWidget {
  Q_OBJECT

 public:
  OperatingStrip(const ModelController& models, SceneController& scene, QWidget* parent = nullptr);

  /// A place for the state of the device, between the operating point and the latency.
  void setDeviceState(QWidget* state);
  /// How long the last edit took until it was felt, or nothing while nothing is felt.
  void showLatency(const QString& latency);

 private:
  void build();
  void showValue(std::size_t input);
  void showSaved();

  const ModelController& models_;
  SceneController& scene_;
  QHBoxLayout* layout_;
  QWidget* point_;
  QLabel* latency_;
  QLabel* saved_;
  std::vector<NumberBox*> numbers_;
};

}  // namespace tactus::workbench
