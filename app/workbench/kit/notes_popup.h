// Sentences in groups under headings, shown over the window until a click elsewhere or Esc; longer lists are scrolled.
#pragma once

#include <QString>
#include <QStringList>
#include <QVector>

class QPoint;
class QWidget;

namespace tactus::workbench {

struct NoteGroup {
  QString heading;  ///< above the sentences
  QStringList sentences;

  bool operator==(const NoteGroup&) const = default;
};

/// Groups without sentences are left out. `corner`: where its upper left corner shall be, in global coordinates; it is
/// kept on the screen of `parent`.
void showNotesPopup(QWidget& parent, const QPoint& corner, const QVector<NoteGroup>& groups);

}  // namespace tactus::workbench
