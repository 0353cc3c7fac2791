// The measurement of depths on an image in a study file.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// The largest image that a study takes: more than a scan of the whole body at 0.33 mm per pixel without compression.
inline constexpr std::size_t kMostImageBytes = 32U << 20U;

/// Adds a record. Returns an error for a text that is no JSON object, an image that is too large, an image beside
/// `image_of`, and an `image_of` that holds none.
base::Result<void> append(StudyFile& file, const study::DepthRecord& record);

/// The latest record, with the image that it uses in `image`, also if another record holds it; nothing if none was
/// measured.
base::Result<std::optional<study::DepthRecord>> depthMeasurement(const StudyFile& file);

}  // namespace tactus::store
