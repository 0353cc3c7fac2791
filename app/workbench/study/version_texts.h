// The texts of the study model's old versions. The study's thread reads the newest in advance, the others on request.
#pragma once

#include <QObject>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "app/workbench/model/edit_controller.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {

/// Thread: gui.
class VersionTexts : public QObject {
  Q_OBJECT

 public:
  /// 64 MiB: enough text for a long run of undo.
  static constexpr std::size_t kMostAheadBytes = std::size_t{64} << 20U;

  explicit VersionTexts(StudyConnection& study, QObject* parent = nullptr);

  /// Drops all texts. Then reads in advance the newest of `versions` (of the open study, oldest first), about
  /// `most_ahead_bytes` of text, so that undo does not have to wait.
  void begin(const std::vector<study::ModelVersion>& versions, std::size_t most_ahead_bytes = kMostAheadBytes);
  /// Returns a version that has been read, or the error of reading it. A version that is not read yet is an error, too;
  /// it is read then.
  EditController::VersionReader reader();

 signals:
  /// A version that a reader requested too early has been read.
  void arrived();

 private:
  using Read = base::Result<study::ModelVersion>;
  struct Shelf {
    std::map<study::RecordId, Read> read;
    std::set<study::RecordId> asked;     ///< requested too early
    std::vector<study::RecordId> ahead;  ///< to be read, in this order
    std::size_t most_bytes = 0;
    std::size_t bytes = 0;
  };
  void ask(const study::RecordId& id);
  void readAhead(std::size_t next);
  /// Reads `wanted` and puts the texts on the shelf; then calls `then`, unless `begin` has made another shelf.
  void read(std::vector<study::RecordId> wanted, std::function<void()> then);

  StudyConnection& study_;
  std::shared_ptr<Shelf> shelf_;
};

}  // namespace tactus::workbench
