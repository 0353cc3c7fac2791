#include "app/workbench/kit/note_groups.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

struct NoteGroups {
  Q_DECLARE_TR_FUNCTIONS(NoteGroups)
};

QStringList sentencesOf(const std::vector<BuildNote>& notes) {
  QStringList out;
  for (const BuildNote& note : notes) out << note.sentence;
  return out;
}

QStringList sentencesAbout(const std::vector<BuildNote>& notes, const std::string& variable) {
  QStringList out;
  for (const BuildNote& note : notes) {
    if (note.subject == variable) out << note.sentence;
  }
  return out;
}

}  // namespace

NoteGroup dataGroup(const BuildNotes& notes) {
  return {NoteGroups::tr("Look at the data first"), sentencesOf(notes.data)};
}

NoteGroup buildGroup(const BuildNotes& notes) {
  return {NoteGroups::tr("Notes of the build"), sentencesOf(notes.build)};
}

QVector<NoteGroup> groupsAbout(const BuildNotes& notes, const fuzzy::Variable& variable) {
  const QString label = labelOf(variable);
  return {{NoteGroups::tr("Look at the data first: %1").arg(label), sentencesAbout(notes.data, variable.id)},
          {NoteGroups::tr("Notes of the build: %1").arg(label), sentencesAbout(notes.build, variable.id)}};
}

QVector<NoteGroup> noticeGroups(const StudyNotices& notices) {
  QStringList now;
  for (const StudyNotice& notice : notices.now) now << notice.sentence;
  return {{NoteGroups::tr("What happened to the study"), now},
          {NoteGroups::tr("Found when it was opened earlier"), notices.before}};
}

qsizetype countOf(const QVector<NoteGroup>& groups) {
  qsizetype count = 0;
  for (const NoteGroup& group : groups) count += group.sentences.size();
  return count;
}

}  // namespace tactus::workbench
