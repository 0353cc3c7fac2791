// What the window tells the user: an act, a note of a build, a notice about a study.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <string>
#include <vector>

namespace tactus::workbench {

// What happened to a study, in the words of the window.

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

/// A sentence about the numbers of a model: what its build from the answers says, or what is odd in the data.
struct BuildNote {
  QString sentence;
  std::string subject;  ///< id of the variable whose terms the note is about; empty: no variable

  bool operator==(const BuildNote&) const = default;
};

struct BuildNotes {
  std::vector<BuildNote> data;   ///< "look at the data first", the worst first (session::dataFindings)
  std::vector<BuildNote> build;  ///< of the build from the answers

  bool operator==(const BuildNotes&) const = default;
  bool isEmpty() const { return data.empty() && build.empty(); }
};

// What a message offers to do about it, for controllers and views alike.

/// The button of a message; without text there is none.
struct MessageAct {
  QString text;  ///< a verb, as in "Save elsewhere…"
  std::function<void()> run;
};

}  // namespace tactus::workbench
