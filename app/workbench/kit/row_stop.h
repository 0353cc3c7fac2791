// A row of fields and buttons, or a column of buttons, that is one stop of Tab: the arrows go along it.
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>

class QKeyEvent;
class QWidget;

namespace tactus::workbench {

/// Tab comes to the part of the row that had the keyboard last, or to the first one that can be used. In a field of
/// text an arrow leaves from its end, or where all of it is selected. A click takes the keyboard where it did before.
class RowStop : public QObject {
  Q_OBJECT

 public:
  /// `parts` from the left, or from above for the arrows up and down. A part that is deleted leaves the row.
  RowStop(const QList<QWidget*>& parts, QObject* parent, Qt::Orientation along = Qt::Horizontal);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Part {
    QPointer<QWidget> widget;
    Qt::FocusPolicy by_click;  ///< of its own: click or none
  };

  bool canStop(qsizetype part) const;
  void stopAt(qsizetype part);
  void stopSomewhere();
  bool goFrom(qsizetype part, const QKeyEvent& key);

  QList<Part> parts_;
  qsizetype stop_ = 0;
  Qt::Orientation along_;
};

}  // namespace tactus::workbench
