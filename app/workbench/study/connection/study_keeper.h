// What keeps more in the study than single records, such as the versions of a model: it is asked when a study is
// opened, written, and closed.
#pragma once

#include <QString>
#include <functional>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::workbench {

/// Thread: gui.
class StudyKeeper {
 public:
  StudyKeeper() = default;
  virtual ~StudyKeeper() = default;
  StudyKeeper(const StudyKeeper&) = delete;
  StudyKeeper& operator=(const StudyKeeper&) = delete;

  /// Takes over what was read. Called while the new study is the open one, before `opened`.
  using Take = std::function<void()>;
  /// Reads the keeper's share of a study, in the thread of the study. An error keeps the study from being opened.
  using ReadShare = std::function<base::Result<Take>(const store::StudyFile&)>;
  virtual ReadShare reader() = 0;
  /// Orders everything that is not ordered yet.
  virtual void orderRest() = 0;
  /// Why an order was refused for another reason than the disk; empty if all is well. The study stays open with it.
  virtual QString refusal() const = 0;
  /// Orders again what was refused.
  virtual void orderAgain() = 0;
  /// The study is written and about to be closed.
  virtual void leave() = 0;
};

}  // namespace tactus::workbench
