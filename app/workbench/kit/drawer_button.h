// A button for a part of the screen that has no place of its own where room is scarce: a press opens it below the
// button. With room the part stands in a layout and the button is hidden.
#pragma once

#include <QPointer>
#include <QToolButton>

class QBoxLayout;
class QFrame;

namespace tactus::workbench {

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

}  // namespace tactus::workbench
