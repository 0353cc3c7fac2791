// Buttons: the one that leads on, padlocks, drawers, help beside a statistic.
#pragma once

#include <QAbstractButton>
#include <QColor>
#include <QPixmap>
#include <QPointF>
#include <QPointer>
#include <QPushButton>
#include <QToolButton>
#include <initializer_list>

#include "app/workbench/base/display_text.h"

class QBoxLayout;
class QFrame;
class QPainter;

namespace tactus::workbench {

// A small "?" beside statistics, which says what they mean.

/// The sentences are its tool tip; a click or the keyboard shows them over the window until the next click or Esc.
class StatisticHelp : public QToolButton {
  Q_OBJECT

 public:
  StatisticHelp(std::initializer_list<Statistic> statistics, QWidget* parent = nullptr);

  QSize sizeHint() const override;
};

/// A small padlock, open or closed. Closed: the vertex beside it may not move.
class LockButton : public QAbstractButton {
  Q_OBJECT

 public:
  explicit LockButton(QWidget* parent = nullptr);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

// A padlock as a drawing.

/// Draws a padlock of 9 x 12 px around `center`, closed or open.
void drawLock(QPainter& painter, const QPointF& center, const QColor& color, bool closed);

/// A closed one on nothing; `dots`: of the screen, per px.
QPixmap lockPicture(const QColor& color, qreal dots);

/// A button for a part of the screen that has no place of its own where room is scarce: a press opens it below the
/// button. With room the part stands in a layout and the button is hidden.
class DrawerButton : public QToolButton {
  Q_OBJECT

 public:
  /// `content` is put at the end of `place`, which must belong to a widget that outlives this.
  DrawerButton(const QString& name, QWidget* content, QBoxLayout& place, QWidget* parent = nullptr);

  /// True: the button is shown in the place of the content.
  void setFolded(bool folded);
  bool isFolded() const { return folded_; }

 private:
  void open();

  QPointer<QWidget> content_;
  QBoxLayout& place_;
  QFrame* drawer_;
  bool folded_ = false;
};

/// The one button of a page that leads on: filled with the accent color.
class PrimaryButton : public QPushButton {
  Q_OBJECT

 public:
  explicit PrimaryButton(const QString& text, QWidget* parent = nullptr);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace tactus::workbench
