// What there is to say about a study and its model, as groups for a NotesButton.
#pragma once

#include "app/workbench/base/build_note.h"
#include "app/workbench/base/study_notice.h"
#include "app/workbench/kit/notes_popup.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// What is odd in the data.
NoteGroup dataGroup(const BuildNotes& notes);
/// What the build says.
NoteGroup buildGroup(const BuildNotes& notes);
/// Of both, what is about the terms of `variable`.
QVector<NoteGroup> groupsAbout(const BuildNotes& notes, const fuzzy::Variable& variable);
/// What happened to a study: the notices of this opening and the incidents of earlier openings.
QVector<NoteGroup> noticeGroups(const StudyNotices& notices);

/// All sentences in `groups`.
qsizetype countOf(const QVector<NoteGroup>& groups);

}  // namespace tactus::workbench
