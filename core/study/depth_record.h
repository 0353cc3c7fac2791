// How the depths of the regions were measured on an image, as stored in a study file (core/store/depth_records.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/study/record_id.h"

namespace tactus::study {

/// One state of the measurement. Append-only: a change, also an undo, is a further record; the latest counts.
struct DepthRecord {
  RecordId id;
  std::int64_t utc_ms = 0;
  std::string author;
  std::string text;                  ///< JSON object (elicitation/depth/depth_measurement.h)
  std::optional<RecordId> image_of;  ///< the record that holds the image; nothing: this one, or there is no image
  std::string image;                 ///< the bytes of the image's file, in the record with which it came; else empty

  bool operator==(const DepthRecord&) const = default;
};

}  // namespace tactus::study
