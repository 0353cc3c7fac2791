// Accepts a model file, a study file or a model of another program dropped anywhere on the window.
#pragma once

#include <QObject>
#include <QString>

class QDropEvent;

namespace tactus::workbench {

/// Accepts one file at a time, by its extension. Text fields do not get the file as text.
class FileDrop : public QObject {
  Q_OBJECT

 public:
  /// `window` owns this.
  explicit FileDrop(QWidget& window);

 signals:
  /// Emitted after the drop has been answered, so that the source program does not wait for the receiver.
  void dropped(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool takes(QDropEvent& event);

  QWidget& window_;
};

}  // namespace tactus::workbench
