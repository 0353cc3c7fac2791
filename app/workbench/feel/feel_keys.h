// The keys while a model is felt: Space holds the tube, F12 and Esc stop, wherever the keyboard focus is.
#pragma once

#include <QObject>

class QKeyEvent;

namespace tactus::workbench {

class FeelController;

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

}  // namespace tactus::workbench
