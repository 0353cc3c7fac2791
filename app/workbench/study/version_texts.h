// The old versions of the study's model: read by the thread of the study, the newest ahead, the others when somebody
// asks for them.
#pragma once

#include <QObject>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "app/workbench/base/call_queue.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/study/study_worker.h"

namespace tactus::workbench {

/// Thread: gui.
class VersionTexts : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kMostAheadBytes = std::size_t{64} << 20U;

  /// `worker` ends before this; `answers` is where it answers.
  VersionTexts(StudyWorker& worker, CallQueue& answers, QObject* parent = nullptr);

  /// Forgets everything and reads those of `versions` (of the study that is open, oldest first) ahead that were added
  /// last, about `most_ahead_bytes` of text, so that undo finds them at once.
  void begin(const std::vector<study::ModelVersion>& versions, std::size_t most_ahead_bytes = kMostAheadBytes);
  /// Gives what has been read, or why it cannot be. A version that was not read yet is an error too, and is read then.
  EditController::VersionReader reader();

 signals:
  /// One that somebody asked for in vain has been read by now.
  void arrived();

 private:
  using Read = base::Result<study::ModelVersion>;
  struct Shelf {
    std::map<study::RecordId, Read> read;
    std::set<study::RecordId> asked;     ///< in vain so far
    std::vector<study::RecordId> ahead;  ///< to be read, in this order
    std::size_t most_bytes = 0;
    std::size_t bytes = 0;
  };
  void ask(const study::RecordId& id);
  void readAhead(std::size_t next);
  /// Reads `wanted` and puts it on the shelf; then `then`, unless there is another shelf by now.
  void read(std::vector<study::RecordId> wanted, std::function<void()> then);

  StudyWorker& worker_;
  CallQueue& answers_;
  std::shared_ptr<Shelf> shelf_;
};

}  // namespace tactus::workbench
