// The strip's label for the device and its state.
#pragma once

#include <QAbstractButton>
#include <QLabel>
#include <QObject>

class QKeyEvent;

namespace tactus::workbench {

class FeelController;

// The keys while a model is felt: Space holds the tube, F12 and Esc stop, wherever the keyboard focus is.

/// Esc stops unless a drag is in progress; then it cancels the drag.
class FeelKeys : public QObject {
  Q_OBJECT

 public:
  explicit FeelKeys(FeelController& feel, QObject* parent = nullptr);

  /// Watches the keys of the whole program, or stops.
  void setOn(bool on);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool escape(QObject& watched, QKeyEvent& key, bool asks);

  FeelController& feel_;
  bool on_ = false;
  bool asking_ = false;        ///< the focused widget is being asked whether it uses Escape
  bool escape_taken_ = false;  ///< it uses Escape
};

/// "Force off": red, in one corner of the window while a device gives forces. It acts on the press.
class ForceOffButton : public QAbstractButton {
  Q_OBJECT

 public:
  explicit ForceOffButton(QWidget* parent = nullptr);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString keys() const;
};

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
