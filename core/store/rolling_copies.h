// The copies that are kept of a study when a program opens it for writing.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::store {

/// Copies the study, as it was opened, to `<file>.copy-1`, with the study's mode; the one that was there becomes
/// `<file>.copy-2`, and an older one goes. Each is a study of its own: renamed, it can be opened. `eraseTraces`
/// (withdrawal.h) removes both. On failure those that were there stay.
base::Result<void> keepCopy(const StudyFile& file);

/// Removes both copies of the study `path`; none there is no failure.
base::Result<void> removeCopies(const std::string& path);

}  // namespace tactus::store
