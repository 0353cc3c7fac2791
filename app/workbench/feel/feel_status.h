// What is felt, in a few words for the strip at the bottom: the device and its state.
#pragma once

#include <QLabel>

namespace tactus::workbench {

class FeelController;

class FeelStatus : public QLabel {
  Q_OBJECT

 public:
  explicit FeelStatus(const FeelController& feel, QWidget* parent = nullptr);

 signals:
  /// How long the last edit took until it was felt; empty while nothing is felt.
  void latencyChanged(const QString& latency);

 private:
  void showState();
  void showLatency();

  const FeelController& feel_;
  QString latency_;
};

}  // namespace tactus::workbench
