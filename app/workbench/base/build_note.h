// A sentence that the build of a model from the answers has about it.
#pragma once

#include <QString>
#include <string>

namespace tactus::workbench {

struct BuildNote {
  QString sentence;
  std::string subject;  ///< id of the variable whose terms it is about; empty: of none

  bool operator==(const BuildNote&) const = default;
};

}  // namespace tactus::workbench
