#include "elicitation/depth/depth_measurement.h"

#include <cmath>
#include <optional>

#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "elicitation/depth/insertion_length.h"

namespace tactus::elicitation {
namespace {

constexpr double kFarPx = 1e6;  // no image is larger

}  // namespace

DepthMeasurement emptyMeasurement(const fuzzy::Variable& depth) {
  DepthMeasurement out;
  out.boundaries = boundariesOf(depth.terms);
  return out;
}

std::string toText(const DepthMeasurement& measurement) {
  base::JsonWriter json;
  json.beginObject(base::JsonWriter::Layout::kInline);
  json.key("image").value(measurement.image).key("example").value(measurement.example);
  json.key("mm_per_px").value(measurement.mm_per_px).key("scale").value(measurement.scale);
  if (measurement.nose_ear_xiphoid_mm) json.key("nose_ear_xiphoid_mm").value(*measurement.nose_ear_xiphoid_mm);
  json.key("path_px").beginArray(base::JsonWriter::Layout::kInline);
  for (const ImagePoint& point : measurement.path) {
    const double both[] = {point.x, point.y};
    json.values(both);
  }
  json.endArray().key("boundaries").beginArray(base::JsonWriter::Layout::kInline);
  for (const DepthBoundary& one : measurement.boundaries) {
    json.beginObject(base::JsonWriter::Layout::kInline);
    json.key("depth_mm").value(one.depth_mm).key("half_overlap_mm").value(one.half_overlap_mm).endObject();
  }
  std::string text = json.endArray().endObject().text();
  text.pop_back();  // the newline of a whole file
  return text;
}

base::Result<DepthMeasurement> readMeasurement(std::string_view text) {
  return base::readJson(text, "depth measurement", [](base::JsonMembers& members, std::optional<base::Error>& error) {
    DepthMeasurement out;
    members.textOrEmpty("image", out.image);
    members.flag("example", out.example);
    members.number(base::required("mm_per_px"), out.mm_per_px, {1e-6, 1e6});
    members.number("scale", out.scale, {0.5, 2});
    members.number("nose_ear_xiphoid_mm", out.nose_ear_xiphoid_mm,
                   {kNoseEarXiphoidMm.from_mm, kNoseEarXiphoidMm.to_mm});
    for (const base::JsonValue value : members.elements("path_px")) {
      std::vector<double> both;
      if (value.kind() == base::JsonKind::kArray) {
        for (const base::JsonValue number : value) {
          if (number.kind() == base::JsonKind::kNumber) both.push_back(number.number());
        }
      }
      if (both.size() != 2 || !(std::abs(both[0]) < kFarPx) || !(std::abs(both[1]) < kFarPx)) {
        members.refuse("path_px", "a list of points [x, y] in px");
        break;
      }
      out.path.push_back({both[0], both[1]});
    }
    for (const base::JsonValue value : members.elements("boundaries")) {
      base::JsonMembers one(value, error);
      DepthBoundary boundary;
      one.number(base::required("depth_mm"), boundary.depth_mm, {-1e5, 1e5});
      one.number(base::required("half_overlap_mm"), boundary.half_overlap_mm, {0, 1e5});
      out.boundaries.push_back(boundary);
    }
    return out;
  });
}

}  // namespace tactus::elicitation
