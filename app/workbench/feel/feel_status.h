// The strip's label for the device and its state.
#pragma once

#include <QLabel>

namespace tactus::workbench {

class FeelController;

class FeelStatus : public QLabel {
  Q_OBJECT

 public:
  explicit FeelStatus(const FeelController& feel, QWidget* parent = nullptr);

 signals:
  /// The time from the last edit to the force; empty while no model is felt.
  void latencyChanged(const QString& latency);

 private:
  void showState();
  void showLatency();

  const FeelController& feel_;
  QString latency_;
};

}  // namespace tactus::workbench
