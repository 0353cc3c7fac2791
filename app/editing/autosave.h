// What a crash must not lose: edits that are not in the study file yet, and the gesture that goes on. The caller writes
// the text to a file of its choice (base::writeFileAtomically) and reads it back at the next start.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editing/history_versions.h"

namespace tactus::editing {

inline constexpr std::size_t kMostAutosaveBytes = std::size_t{256} << 20U;  ///< to give to base::readFile

struct Autosave {
  /// A gesture that was going on.
  struct Unfinished {
    std::string label;
    fuzzy::ForceModel model;
  };

  std::string document;                       ///< what was being edited, as the caller names it: a path
  std::vector<study::ModelVersion> versions;  ///< that were not stored, parents first
  std::optional<Unfinished> unfinished;
};

/// Events of a history by their index, from `first` up to the one before `last`.
struct EventRange {
  std::size_t first = 0;
  std::size_t last = std::numeric_limits<std::size_t>::max();
};

/// JSON of everything in `history` that is not stored; `document` says of what. A long history can be written in parts:
/// then of the events in `range` alone, and of the gesture that goes on where the range includes the last event.
std::string autosaveText(const EditHistory& history, const std::string& document, EventRange range = {});

/// Whether there is anything that a crash would lose. A model that was opened and left as it is would not be.
bool needsAutosave(const EditHistory& history);

/// Reads such a text, said to be of `file` in errors. Every model is validated and must fit its SHA-256.
base::Result<Autosave> parseAutosave(std::string_view text, const std::string& file);

/// The versions of `autosave` that a study with the versions `stored` lacks: to be appended in this order. Appending
/// twice adds nothing.
std::vector<study::ModelVersion> lostVersions(const Autosave& autosave, std::span<const study::ModelVersion> stored);

/// The history after a crash: `stored` (as for historyFrom) and then what the study lacked, which is marked as not
/// stored and has its models in memory. The gesture that was going on becomes one edit, `… (recovered)`, with the
/// author and time of `stamp`.
base::Result<EditHistory> recovered(std::span<const study::ModelVersion> stored, const Autosave& autosave,
                                    study::RecordIds ids, const Stamp& stamp);

}  // namespace tactus::editing
