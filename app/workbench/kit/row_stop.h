// A row of fields and buttons that is one stop of Tab: the arrows left and right go along it.
#pragma once

#include <QList>
#include <QObject>

class QKeyEvent;
class QWidget;

namespace tactus::workbench {

/// Tab comes to the part of the row that had the keyboard last, the first one at the beginning. In a field of text an
/// arrow leaves from its end, or where all of it is selected.
class RowStop : public QObject {
  Q_OBJECT

 public:
  /// `parts` from the left; they live as long as this.
  RowStop(QList<QWidget*> parts, QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void stopAt(qsizetype part);
  bool goFrom(qsizetype part, const QKeyEvent& key);

  QList<QWidget*> parts_;
};

}  // namespace tactus::workbench
