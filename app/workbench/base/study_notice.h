// What happened to a study, in the words of the window.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace tactus::workbench {

/// One thing to know of the opening of a study: what happened, what it means, and what to do.
struct StudyNotice {
  QString sentence;
  /// An erasure that was interrupted: StudyConnection::finishErasure ends it.
  bool can_be_finished = false;

  bool operator==(const StudyNotice&) const = default;
};

struct StudyNotices {
  std::vector<StudyNotice> now;  ///< of this opening
  QStringList before;            ///< of earlier openings, a sentence each with its time, the oldest first

  bool operator==(const StudyNotices&) const = default;
};

}  // namespace tactus::workbench
