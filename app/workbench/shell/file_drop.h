// A model or study file that is dropped on the window, wherever it falls.
#pragma once

#include <QObject>
#include <QString>

class QDropEvent;

namespace tactus::workbench {

/// Takes one file at a time, named like a model or a study. A field under the mouse does not get it as text.
class FileDrop : public QObject {
  Q_OBJECT

 public:
  /// Belongs to `window`.
  explicit FileDrop(QWidget& window);

 signals:
  /// Once the program that the file comes from has been answered: it does not wait for what follows here.
  void dropped(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool takes(QDropEvent& event);

  QWidget& window_;
};

}  // namespace tactus::workbench
