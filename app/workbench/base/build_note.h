// A sentence about the numbers of a model: what its build from the answers says, or what is odd in the data.
#pragma once

#include <QString>
#include <string>
#include <vector>

namespace tactus::workbench {

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

}  // namespace tactus::workbench
