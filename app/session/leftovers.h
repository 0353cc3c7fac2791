// Leftovers of crashes beside a study file or an export. They may hold data of the study.
#pragma once

#include <string>
#include <vector>

namespace tactus::session {

/// A file or folder that no running program uses.
struct Leftover {
  std::string path;
  /// Its name shows that Tactus made it (base/unfinished.h), so it can be deleted without a question. False: it looks
  /// like a leftover of an older Tactus, but a person may have made it.
  bool is_ours = false;

  bool operator==(const Leftover&) const = default;
};

/// Everything left beside the study file `study`, and unfinished exports in its folder; sorted by name.
std::vector<Leftover> leftoversOfStudy(const std::string& study);

/// Unfinished exports of this name beside the export folder `folder`; sorted by name.
std::vector<Leftover> leftoversOfExport(const std::string& folder);

/// Deletes the leftovers with `is_ours` that are still unused. Returns the deleted paths.
std::vector<std::string> removeOurs(const std::vector<Leftover>& leftovers);

/// One sentence about a leftover, for the user.
std::string sentence(const Leftover& leftover);

}  // namespace tactus::session
