// Layout and keyboard: rows, columns and splitters in one expression, page stacks, tabs, rows that are one stop, the
// order of Tab.
#pragma once

#include <QBoxLayout>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QSplitter>
#include <QStackedWidget>
#include <initializer_list>

#include "app/workbench/base/theme.h"

class QKeyEvent;
class QTabBar;
class QTabWidget;

namespace tactus::workbench {

// Rows, columns and splitters. Example: makeColumn(this, {title, {plot, 1}, makeRow({spring(), ok, cancel})});

/// A part of a row, a column or a splitter: a widget, a layout or empty room.
struct LayoutPart {
  LayoutPart(QWidget* one, int share = 0, Qt::Alignment side = {})  // NOLINT(google-explicit-constructor)
      : widget(one), stretch(share), at(side) {}
  LayoutPart(QLayout* inner, int share = 0) : layout(inner), stretch(share) {}  // NOLINT(google-explicit-constructor)

  QWidget* widget = nullptr;
  QLayout* layout = nullptr;
  int stretch = 0;  ///< share of the room that is left
  Qt::Alignment at;
  int gap_px = 0;  ///< of empty room
};

/// Empty room that takes what is left, or its share of it.
LayoutPart spring(int share = 0);
/// Empty room of `px`.
LayoutPart gap(int px);

inline constexpr int kStyleGap = -1;  ///< between parts: as in the layout around them, or as the style has it

inline QMargins inset(int px) { return {px, px, px, px}; }
inline QMargins inset(int across, int down) { return {across, down, across, down}; }

/// `between`: px from part to part. With `owner` it is the layout of that widget.
QHBoxLayout* makeRow(QWidget* owner, std::initializer_list<LayoutPart> parts, int between = theme::kGrid,
                     QMargins around = {});
QHBoxLayout* makeRow(std::initializer_list<LayoutPart> parts, int between = theme::kGrid, QMargins around = {});
QVBoxLayout* makeColumn(QWidget* owner, std::initializer_list<LayoutPart> parts, int between = theme::kGrid,
                        QMargins around = {});
QVBoxLayout* makeColumn(std::initializer_list<LayoutPart> parts, int between = theme::kGrid, QMargins around = {});
/// Widgets with handles between them. None of them can be closed with a handle.
QSplitter* makeSplit(Qt::Orientation along, std::initializer_list<LayoutPart> widgets);

/// Two parts side by side, the first of which takes what is left; above each other where they do not fit.
class FoldingRow : public QWidget {
 public:
  FoldingRow(QBoxLayout* first, QBoxLayout* second, QWidget* parent = nullptr);

  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void fold();

  QBoxLayout* first_;
  QBoxLayout* second_;
  QBoxLayout* parts_;
};

/// Makes the window higher wherever its texts, broken into lines, need more room: when it is shown, and when they
/// change.
void keepWhole(QWidget& window);

// The Tab order of a window: reading order, group by group, from top to bottom and from left to right. The order of
// creation does not matter.

/// The visible widgets of `window` that Tab can reach, in reading order. Leaves out a scroll area if all its content is
/// visible.
QList<QWidget*> readingOrder(const QWidget& window);

/// Moves the focus to the next widget (`forward`) or the previous one, and scrolls it into view. Returns false if there
/// is none.
bool focusNextAsRead(const QWidget& window, bool forward);

// A row of fields and buttons, or a column of buttons, that is one stop of Tab: the arrows go along it.

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

// Makes the current tab easy to see in both looks.

/// The current tab has the normal text color and, in the dark look, a lighter background. The other tabs have the color
/// of secondary text. No line is drawn below the tabs.
class TabLook : public QObject {
  Q_OBJECT

 public:
  /// `bar` owns this object.
  explicit TabLook(QTabBar& bar);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show();

  QTabBar& bar_;
};

/// Pages with tabs of this look, without a frame.
QTabWidget* makeTabs(QWidget* parent = nullptr);

// Pages on each other, of which one is in sight.

/// A stack whose height does not follow from its width. Otherwise each label that gets another text anywhere in the
/// window has every wrapped text of every page measured again, also of the pages out of sight.
class PageStack : public QStackedWidget {
 public:
  using QStackedWidget::QStackedWidget;
  bool hasHeightForWidth() const override { return false; }
};

}  // namespace tactus::workbench
