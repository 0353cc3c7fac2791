// A button that shows the number of notes and opens their list below itself.
#pragma once

#include <QToolButton>

#include "app/workbench/kit/notes_popup.h"

namespace tactus::workbench {

class NotesButton : public QToolButton {
  Q_OBJECT

 public:
  explicit NotesButton(QWidget* parent = nullptr);

  /// Shows `groups` under `words`, the text of the button, in the ink of warnings where `warns`. Without a sentence in
  /// them the button is hidden.
  void setNotes(const QString& words, const QVector<NoteGroup>& groups, bool warns = false);
  /// `1 note`, `12 notes`: what the words can be.
  static QString counted(qsizetype notes);
  const QVector<NoteGroup>& notes() const { return groups_; }
  /// Whether there is a sentence in them.
  bool hasNotes() const;

 private:
  void showNotes();

  QVector<NoteGroup> groups_;
  bool warns_ = false;
};

}  // namespace tactus::workbench
