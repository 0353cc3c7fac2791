// The text of an autosave: edits that are not in the study file yet, and the current gesture. The caller writes the
// text to a file (base::writeFileAtomically) and reads it at the next start.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editing/history_versions.h"

namespace tactus::editing {

inline constexpr std::size_t kMostAutosaveBytes = std::size_t{256} << 20U;  ///< limit for base::readFile: 256 MiB

struct Autosave {
  /// A gesture that was in progress.
  struct Unfinished {
    std::string label;
    fuzzy::ForceModel model;
  };

  std::string document;                       ///< the edited document, as the caller names it: a path
  std::vector<study::ModelVersion> versions;  ///< not stored; parents first
  std::optional<Unfinished> unfinished;
};

/// Events of a history by index: from `first` to the one before `last`.
struct EventRange {
  std::size_t first = 0;
  std::size_t last = std::numeric_limits<std::size_t>::max();
};

/// JSON of everything in `history` that is not stored; `document` names the document. A long history can be written in
/// parts: the text then has only the events in `range`, and the gesture only if `range` includes the last event.
std::string autosaveText(const EditHistory& history, const std::string& document, EventRange range = {});

/// Whether a crash would lose anything. False for a model that was opened and not edited.
bool needsAutosave(const EditHistory& history);

/// Reads such a text; errors name `file`. Every model is validated and must match its SHA-256.
base::Result<Autosave> parseAutosave(std::string_view text, const std::string& file);

/// The versions of `autosave` that are missing in a study with the versions `stored`. Append them in this order. A
/// second call after that returns none.
std::vector<study::ModelVersion> lostVersions(const Autosave& autosave, std::span<const study::ModelVersion> stored);

/// The history after a crash: `stored` (as for historyFrom), then the versions that the study lacks. These are marked
/// as not stored and keep their models in memory. The interrupted gesture becomes one edit, `… (recovered)`, with the
/// author and time of `stamp`.
base::Result<EditHistory> recovered(std::span<const study::ModelVersion> stored, const Autosave& autosave,
                                    study::RecordIds ids, const Stamp& stamp);

}  // namespace tactus::editing
