// A button that says how many notes there are about something, and shows them below itself.
#pragma once

#include <QStringList>
#include <QToolButton>

namespace tactus::workbench {

class NotesButton : public QToolButton {
  Q_OBJECT

 public:
  explicit NotesButton(QWidget* parent = nullptr);

  /// `title` stands above the notes. Without notes the button is hidden.
  void setNotes(const QString& title, const QStringList& notes);
  const QStringList& notes() const { return notes_; }

 private:
  void showNotes();

  QString title_;
  QStringList notes_;
};

}  // namespace tactus::workbench
