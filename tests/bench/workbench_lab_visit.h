// All labs of a study in the real window, without a display: what a large study takes.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace tactus::bench {

struct LabVisit {
  std::string lab;
  double done_s = 0;           ///< until nothing more is computed
  double first_s = 0;          ///< until the work is told or done, whichever comes first
  double shown_s = 0;          ///< until the lab shows a result, which may still improve
  double longest_ms = 0;       ///< longest time in which the thread of the window handled no event
  double longest_cpu_ms = 0;   ///< of the same thread, longest time on a processor for one event
  double peak_mb = 0;          ///< largest memory of the process so far
  std::set<std::string> said;  ///< what the screen said of its work, without numbers
};

/// Opens the study file `path` in a window of 1920 x 1080 px and goes through all labs and their pages. A QApplication
/// must exist.
std::vector<LabVisit> visitLabs(const std::string& path);

}  // namespace tactus::bench
