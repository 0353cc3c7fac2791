// What there is to say about the data of the open study and about the build of its model. The thread of the study
// reads the data, a thread of its own looks at them, so neither the window nor what is to be stored waits for that.
#pragma once

#include <QObject>
#include <cstdint>
#include <optional>

#include "app/workbench/base/worker.h"
#include "app/workbench/base/messages.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {

/// Thread: gui.
class StudyReview : public QObject {
  Q_OBJECT

 public:
  explicit StudyReview(StudyConnection& study, QObject* parent = nullptr);

  /// Forgets everything and looks at the study that is open. `model`: a version of the model whose notes are wanted.
  /// They come from building it once more; where that gives another model than the first version of this one, a note
  /// says so. Without `model` there are no notes of a build.
  void begin(const std::optional<study::RecordId>& model);
  /// Takes what is known already.
  void set(BuildNotes notes);
  void clear() { set({}); }

  const BuildNotes& notes() const { return notes_; }
  /// Something is to come.
  bool isBusy() const { return busy_; }

 signals:
  void changed();

 private:
  void take(BuildNotes notes);

  StudyConnection& study_;
  BuildNotes notes_;
  bool busy_ = false;
  std::uint64_t newest_ = 0;  ///< what was begun before does not count any more
  Background background_;
};

}  // namespace tactus::workbench
