#include "app/workbench/kit/notes_button.h"

#include <algorithm>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

NotesButton::NotesButton(QWidget* parent) : QToolButton(parent) {
  setFont(theme::smallFont());
  setAutoRaise(true);
  setFocusPolicy(Qt::TabFocus);
  hide();
  connect(this, &QToolButton::clicked, this, &NotesButton::showNotes);
}

QString NotesButton::counted(qsizetype notes) { return tr("%n note(s)", nullptr, static_cast<int>(notes)); }

void NotesButton::setNotes(const QString& words, const QVector<NoteGroup>& groups, bool warns) {
  if (words == text() && groups == groups_ && warns == warns_) return;
  groups_ = groups;
  warns_ = warns;
  setText(words);
  QStringList headings;
  for (const NoteGroup& group : groups) {
    if (!group.sentences.isEmpty()) headings << group.heading;
  }
  setToolTip(headings.join(QStringLiteral(" · ")));
  setAccessibleName(words);
  setAccessibleDescription(toolTip());
  QPalette colors;
  if (warns) colors.setColor(QPalette::ButtonText, theme::warningInk());
  setPalette(colors);
  setVisible(!headings.isEmpty());
}

bool NotesButton::hasNotes() const {
  return std::any_of(groups_.begin(), groups_.end(), [](const NoteGroup& one) { return !one.sentences.isEmpty(); });
}

void NotesButton::showNotes() { showNotesPopup(*this, mapToGlobal(QPoint(0, height() + 4)), groups_); }

}  // namespace tactus::workbench
