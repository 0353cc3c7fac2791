// The participants' codes at the welcome: a new one, and who has the code that was typed.
#pragma once

#include <optional>
#include <string>

#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

/// The person with a typed code, and what is kept of them.
struct KnownPerson {
  std::optional<study::Person> person;     ///< nothing: no code of this study
  std::string meant;                       ///< a code that may have been meant; may be empty
  std::optional<study::RecordId> session;  ///< the latest on these screens that was not ended early
  int answers = 0;                         ///< scored judgements and replies to questions in it, corrected ones once
};

/// Thread: that of `file`.
base::Result<KnownPerson> knownPerson(const store::StudyFile& file, const std::string& typed);

/// A code that no participant has or had. Thread: that of `file`.
base::Result<std::string> newCode(const store::StudyFile& file);

}  // namespace tactus::workbench
