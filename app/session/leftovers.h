// What crashes left beside a study file or an export: it may hold data of the study.
#pragma once

#include <string>
#include <vector>

namespace tactus::session {

/// A file or folder that no running program uses.
struct Leftover {
  std::string path;
  /// Its name says that Tactus made it (base/unfinished.h), so that it can be deleted without a question. Otherwise it
  /// looks like what an older Tactus left, but a person may have made it too.
  bool is_ours = false;

  bool operator==(const Leftover&) const = default;
};

/// In the folder of the study file `study`, by name: whatever was left beside it, and unfinished exports.
std::vector<Leftover> leftoversOfStudy(const std::string& study);

/// Beside the export folder `folder`, by name: unfinished exports of this name.
std::vector<Leftover> leftoversOfExport(const std::string& folder);

/// Deletes what is ours and still unused; the paths of what was deleted.
std::vector<std::string> removeOurs(const std::vector<Leftover>& leftovers);

/// One sentence about a leftover, for the person.
std::string sentence(const Leftover& leftover);

}  // namespace tactus::session
