#include "app/workbench/note_parts.h"

#include <QAction>
#include <QMenuBar>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/study/study_notice_strip.h"
#include "app/workbench/tune/terms/membership_editor.h"

namespace tactus::workbench {

NoteParts::NoteParts(MainWindow& window, StudyConnection& study, StudyModels& study_models, MembershipEditor& editor)
    : window_(window),
      study_(study),
      study_models_(study_models),
      editor_(editor),
      strip_(new StudyNoticeStrip(study, &window)) {
  window_.addStrip(strip_);
  WindowMenus& menus = window_.menus();
  notices_ = menus.addAction(MenuSlot::kStudyNotes, tr("Show what &happened to the study"));
  data_ = menus.addAction(MenuSlot::kStudyNotes, tr("&Look at the data first"));
  build_ = menus.addAction(MenuSlot::kStudyNotes, tr("Show the n&otes of the build"));
  connect(notices_, &QAction::triggered, this, [this] {
    strip_->showAll();
    if (!study_.notices().before.isEmpty()) popUp(noticeGroups(study_.notices()));
  });
  connect(data_, &QAction::triggered, this, [this] { popUp({dataGroup(study_models_.notes())}); });
  connect(build_, &QAction::triggered, this, [this] { popUp({buildGroup(study_models_.notes())}); });
  connect(&study_models_, &StudyModels::notesChanged, this, &NoteParts::showNotes);
  connect(&study_, &StudyConnection::noticesChanged, this, &NoteParts::showNotices);
  // The notes of the build are of the study's model alone.
  connect(&study_models_, &StudyModels::savedChanged, this, &NoteParts::showNotes);
  showNotes();
  showNotices();
}

void NoteParts::showNotes() {
  BuildNotes notes = study_models_.notes();
  data_->setEnabled(!notes.data.empty());
  build_->setEnabled(!notes.build.empty());
  if (!study_models_.keepsModel()) notes.build.clear();
  window_.header().showNotes(notes);
  // What is odd in the data of the study says nothing of terms that are of another model.
  editor_.setNotes(study_models_.keepsModel() ? std::move(notes) : BuildNotes());
}

void NoteParts::showNotices() {
  const StudyNotices& notices = study_.notices();
  notices_->setEnabled(!notices.now.empty() || !notices.before.isEmpty());
  window_.header().showNotices(notices);
}

void NoteParts::popUp(const QVector<NoteGroup>& groups) {
  const QMenuBar* bar = window_.menuBar();
  showNotesPopup(window_, bar->mapToGlobal(QPoint(theme::kGrid, bar->height() + 4)), groups);
}

}  // namespace tactus::workbench
