#include "elicitation/depth/depth_measurement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "elicitation/depth/insertion_length.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::fail;

constexpr double kSmallestScale = 0.5;
constexpr double kLargestScale = 2;

std::string between(const fuzzy::Variable& depth, std::size_t gap) {
  return "boundary of " + depth.terms[gap].id + " and " + depth.terms[gap + 1].id;
}

std::string mm(double depth_mm) { return base::roundedNumber(depth_mm) + " mm"; }

}  // namespace

base::Result<std::vector<fuzzy::Term>> depthTerms(const fuzzy::Variable& depth,
                                                  std::span<const DepthBoundary> boundaries, double scale) {
  if (boundaries.size() + 1 != depth.terms.size()) {
    return fail(ErrorCode::kData, "regions", std::to_string(boundaries.size()) + " boundaries",
                std::to_string(depth.terms.size() - 1) + ", one fewer than regions");
  }
  if (!(scale >= kSmallestScale && scale <= kLargestScale)) {
    return fail(ErrorCode::kValue, "anatomical scale", base::roundedNumber(scale), "a factor from 0.5 to 2");
  }
  double before_mm = depth.min;  // where the last ramp ends
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    const DepthBoundary& one = boundaries[k];
    if (!std::isfinite(one.depth_mm) || !(std::isfinite(one.half_overlap_mm) && one.half_overlap_mm >= 0)) {
      return fail(ErrorCode::kValue, between(depth, k), "a number that is not finite, or a negative overlap",
                  "a depth, and an overlap of 0 mm or more");
    }
    const double begin_mm = scale * (one.depth_mm - one.half_overlap_mm);
    const double end_mm = scale * (one.depth_mm + one.half_overlap_mm);
    if (begin_mm < before_mm) {
      return fail(ErrorCode::kData, between(depth, k), "a ramp from " + mm(begin_mm),
                  "a begin at or behind " + mm(before_mm) + ", where the ramp before ends");
    }
    if (end_mm > depth.max) {
      return fail(ErrorCode::kData, between(depth, k), "a ramp to " + mm(end_mm),
                  "an end within the universe, " + mm(depth.max));
    }
    before_mm = end_mm;
  }
  std::vector<fuzzy::Term> terms = depth.terms;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const auto begin = [&](std::size_t gap) {
      return scale * (boundaries[gap].depth_mm - boundaries[gap].half_overlap_mm);
    };
    const auto end = [&](std::size_t gap) {
      return scale * (boundaries[gap].depth_mm + boundaries[gap].half_overlap_mm);
    };
    const bool first = k == 0;
    const bool last = k + 1 == terms.size();
    terms[k].shape = fuzzy::Shape::kTrapezoid;
    terms[k].points = {first ? depth.min : begin(k - 1), first ? depth.min : end(k - 1), last ? depth.max : begin(k),
                       last ? depth.max : end(k)};
  }
  return terms;
}

std::vector<DepthBoundary> boundariesOf(std::span<const fuzzy::Term> terms) {
  std::vector<DepthBoundary> out;
  for (std::size_t k = 0; k + 1 < terms.size(); ++k) {
    const double begin_mm = terms[k].points[2];
    const double end_mm = terms[k].points[3];
    out.push_back({(begin_mm + end_mm) / 2, (end_mm - begin_mm) / 2});
  }
  return out;
}

std::string_view name(DepthsFrom from) noexcept { return from == DepthsFrom::kMeasured ? "measured" : "template"; }

base::Result<std::vector<fuzzy::Term>> measuredTerms(const DepthMeasurement& measurement, const fuzzy::Variable& depth,
                                                     const std::vector<fuzzy::Term>& set) {
  // All regions are checked first, so that an error names the same boundary whatever the form asks.
  if (auto all = depthTerms(depth, measurement.boundaries, measurement.scale); !all) return all;
  fuzzy::Variable some = depth;
  some.terms = set;
  std::vector<DepthBoundary> ends;
  for (std::size_t k = 0; k + 1 < set.size(); ++k) {
    const auto region = std::find_if(depth.terms.begin(), depth.terms.end(),
                                     [&](const fuzzy::Term& one) { return one.id == set[k].id; });
    const auto index = static_cast<std::size_t>(region - depth.terms.begin());
    if (index >= measurement.boundaries.size()) {
      return base::fail(base::ErrorCode::kReference, "depth terms", base::quoted(set[k].id),
                        "a region of the measurement with another one behind it");
    }
    ends.push_back(measurement.boundaries[index]);
  }
  return depthTerms(some, ends, measurement.scale);
}

std::string measuredSentence(const DepthMeasurement& measurement) {
  const std::string where = measurement.image.empty()
                                ? "typed, without an image"
                                : "measured on the image " + base::quoted(measurement.image) + " (" +
                                      base::roundedNumber(measurement.mm_per_px) + " mm per pixel" +
                                      (measurement.example ? ", a drawing, not a person" : "") + ")";
  return "The depths of the regions are " + where + ", anatomical scale " + base::roundedNumber(measurement.scale) +
         ".";
}

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
