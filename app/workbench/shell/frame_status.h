// The strip's label for the time from the last edit to the plots.
#pragma once

#include <QLabel>
#include <QTimer>

namespace tactus::workbench {

class FrameClock;

class FrameStatus : public QLabel {
  Q_OBJECT

 public:
  /// `clock` outlives this.
  explicit FrameStatus(const FrameClock& clock, QWidget* parent = nullptr);

 protected:
  bool event(QEvent* event) override;

 private:
  void showLast();
  QString explanation() const;

  const FrameClock& clock_;
  QTimer calm_;
};

}  // namespace tactus::workbench
