// The states of a study's force models. They can be added, never changed. Undo, snapshots and sign-off add versions.
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// Adds a version and stores the SHA-256 of its text. `version.sha256`: empty, or equal to it. Returns an error for an
/// existing id, an unknown parent, or a model with an expert who withdrew from the study.
base::Result<void> append(StudyFile& file, const study::ModelVersion& version);

/// All versions from the oldest to the latest, without their texts.
base::Result<std::vector<study::ModelVersion>> modelVersions(const StudyFile& file);

/// One version with its text. Returns an error if it does not exist or its text does not match its SHA-256.
base::Result<study::ModelVersion> modelVersion(const StudyFile& file, const study::RecordId& id);

/// The version added last, with its text; nothing if there is none.
base::Result<std::optional<study::ModelVersion>> latestModelVersion(const StudyFile& file);

/// The chain of parents of `id` up to the first version, without their texts.
base::Result<std::vector<study::ModelVersion>> modelAncestors(const StudyFile& file, const study::RecordId& id);

}  // namespace tactus::store
