// One way to begin on the start screen: its name, and in small letters what it leads to.
#pragma once

#include <QAbstractButton>

namespace tactus::workbench {

class StartEntry : public QAbstractButton {
  Q_OBJECT

 public:
  StartEntry(const QString& name, const QString& note, QWidget* parent = nullptr);

  void setNote(const QString& note);
  const QString& note() const { return note_; }
  /// True: the entry that a newcomer should take, on the accent color.
  void setPrimary(bool primary);
  /// Notes in one line, cut in the middle where it is too long; otherwise they take as many lines as they need.
  void setOneLine(bool one_line);

  QSize sizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QRect nameRect(int width) const;
  QRect noteRect(int width) const;

  QString note_;
  bool primary_ = false;
  bool one_line_ = false;
};

}  // namespace tactus::workbench
