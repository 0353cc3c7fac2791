#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/procedure/procedure.h"
#include "core/procedure/svg.h"

namespace tactus::procedure {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

/// A value for each point, from one for each node: even along the line in between.
std::vector<double> spread(const SvgLine& line, const std::vector<double>& lengths, const std::vector<double>& nodes) {
  std::vector<double> out(lengths.size());
  for (std::size_t i = 0, piece = 0; i < out.size(); ++i) {
    while (piece + 2 < line.nodes.size() && i > line.nodes[piece + 1]) ++piece;
    const double begin = lengths[line.nodes[piece]];
    const double length = lengths[line.nodes[piece + 1]] - begin;
    const double share = length > 0 ? (lengths[i] - begin) / length : 0;
    out[i] = nodes[piece] + share * (nodes[piece + 1] - nodes[piece]);
  }
  return out;
}

/// The place of each point: those of the nodes as given, or spread evenly over the whole length.
Result<std::vector<double>> placesOf(const SvgLine& line, const std::string* given, double from_mm, double to_mm) {
  const std::vector<double> lengths = lengthsOf(line.points);
  if (!(lengths.back() > 0)) return fail(ErrorCode::kValue, "path 'way'", "a path of no length", "a line");
  std::vector<double> nodes;
  if (given != nullptr) {
    const auto read = svgNumbers(*given);
    const std::string wanted = std::to_string(line.nodes.size()) + " rising numbers from " +
                               base::formatNumber(from_mm) + " to at most " + base::formatNumber(to_mm) +
                               ", one for each node of the path";
    const bool rises = read && std::is_sorted(read->begin(), read->end()) &&
                       std::adjacent_find(read->begin(), read->end()) == read->end();
    if (!rises || read->size() != line.nodes.size() || read->front() != from_mm || read->back() > to_mm)
      return fail(ErrorCode::kValue, "data-mm of the path 'way'", base::quoted(*given), wanted);
    nodes = *read;
  } else {
    for (const std::size_t node : line.nodes)
      nodes.push_back(from_mm + (to_mm - from_mm) * lengths[node] / lengths.back());
  }
  return spread(line, lengths, nodes);
}

/// How far each point lies before the plane of the picture; in it without `given`.
Result<std::vector<double>> acrossOf(const SvgLine& line, const std::string* given) {
  if (given == nullptr) return std::vector<double>(line.points.size(), 0);
  const auto read = svgNumbers(*given);
  if (!read || read->size() != line.nodes.size()) {
    return fail(ErrorCode::kValue, "data-across of the path 'way'", base::quoted(*given),
                std::to_string(line.nodes.size()) + " numbers, one for each node of the path");
  }
  return spread(line, lengthsOf(line.points), *read);
}

/// The part of the view box that the line encloses, as a share of it.
double shareInside(const Picture& picture, const std::vector<Point>& line) {
  constexpr int kRows = 40;
  double share = 0;
  for (int row = 0; row < kRows; ++row) {
    const double y = picture.top + picture.height * (row + 0.5) / kRows;
    std::vector<double> crossings;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Point& a = line[i];
      const Point& b = line[(i + 1) % line.size()];
      if ((a.y <= y) == (b.y <= y)) continue;
      const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      crossings.push_back(std::clamp(x, picture.left, picture.left + picture.width));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) share += crossings[i + 1] - crossings[i];
  }
  return share / picture.width / kRows;
}

/// Of the whole body, which a picture may have: its path 'outline', how broad the body is and where its front is.
Result<void> readOutline(const std::vector<SvgElement>& elements, Picture& out) {
  const SvgElement* const element = withId(elements, "outline");
  if (element == nullptr) return {};
  TACTUS_TRY(auto outline, pathWithId(elements, "outline"));
  out.outline = std::move(outline.second.points);
  constexpr double kLeastShare = 0.01;
  if (shareInside(out, out.outline) < kLeastShare) {
    return fail(ErrorCode::kValue, "path 'outline'", "a line that encloses less than a hundredth of the picture",
                "the outline of the whole body");
  }
  if (const std::string* const breadth = element->attribute("data-breadth")) {
    out.breadth = base::parseNumber(*breadth);
    if (!out.breadth || !(*out.breadth > 0) || *out.breadth > 10 * (out.width + out.height)) {
      return fail(ErrorCode::kValue, "data-breadth of the path 'outline'", base::quoted(*breadth),
                  "how broad the body is at its broadest, in the units of the picture");
    }
  }
  static constexpr std::pair<std::string_view, FrontSide> kFronts[] = {{"left", FrontSide::kLeft},
                                                                       {"right", FrontSide::kRight},
                                                                       {"top", FrontSide::kTop},
                                                                       {"bottom", FrontSide::kBottom}};
  if (const std::string* const front = element->attribute("data-front")) {
    const auto* const found =
        std::find_if(std::begin(kFronts), std::end(kFronts), [&](const auto& one) { return one.first == *front; });
    if (found == std::end(kFronts)) {
      return fail(ErrorCode::kValue, "data-front of the path 'outline'", base::quoted(*front),
                  "'left', 'right', 'top' or 'bottom'");
    }
    out.front = found->second;
  }
  return {};
}

/// The way of the tool to where it enters, which a picture may have: its path 'approach'.
Result<void> readApproach(const std::vector<SvgElement>& elements, Picture& out) {
  if (withId(elements, "approach") == nullptr) return {};
  TACTUS_TRY(auto approach, pathWithId(elements, "approach"));
  out.approach = std::move(approach.second.points);
  const Point& end = out.approach.back();
  const Point& begin = out.way.front();
  if (std::hypot(end.x - begin.x, end.y - begin.y) > 0.01 * (out.width + out.height)) {
    return fail(
        ErrorCode::kValue, "path 'approach'",
        "a line that ends at " + base::formatNumber(end.x) + " " + base::formatNumber(end.y),
        "one that ends where the way begins, " + base::formatNumber(begin.x) + " " + base::formatNumber(begin.y));
  }
  return {};
}

/// The part that most questions are about, which a picture may name.
Result<void> readNear(const SvgElement& svg, Picture& out) {
  const std::string* const given = svg.attribute("data-near");
  if (given == nullptr) return {};
  const auto read = svgNumbers(*given);
  if (!read || read->size() != 4 || !((*read)[2] > 0) || !((*read)[3] > 0)) {
    return fail(ErrorCode::kValue, "data-near", base::quoted(*given),
                "four numbers: left, top, width, height of a part of the picture");
  }
  out.near = {(*read)[0], (*read)[1], (*read)[2], (*read)[3]};
  return {};
}

Result<Picture> readElements(const std::vector<SvgElement>& elements, double from_mm, double to_mm,
                             const std::vector<std::string>& regions) {
  Picture out;
  const std::string* const box = elements.front().attribute("viewBox");
  const auto numbers = box != nullptr ? svgNumbers(*box) : std::nullopt;
  if (!numbers || numbers->size() != 4 || !((*numbers)[2] > 0) || !((*numbers)[3] > 0)) {
    return fail(ErrorCode::kSchema, "viewBox", box != nullptr ? base::quoted(*box) : "nothing",
                "four numbers: left, top, width, height");
  }
  out.left = (*numbers)[0];
  out.top = (*numbers)[1];
  out.width = (*numbers)[2];
  out.height = (*numbers)[3];
  TACTUS_TRY(auto way, pathWithId(elements, "way"));
  const SvgElement& of_way = *withId(elements, "way");
  TACTUS_TRY(out.way_mm, placesOf(way.second, of_way.attribute("data-mm"), from_mm, to_mm));
  TACTUS_TRY(out.way_across, acrossOf(way.second, of_way.attribute("data-across")));
  out.way = std::move(way.second.points);
  for (const std::string& region : regions) {
    TACTUS_TRY(auto outline, pathWithId(elements, "region_" + region));
    out.regions.emplace(region, std::move(outline.first));
  }
  if (auto ok = readOutline(elements, out); !ok) return tl::unexpected(std::move(ok).error());
  if (auto ok = readApproach(elements, out); !ok) return tl::unexpected(std::move(ok).error());
  if (auto ok = readNear(elements.front(), out); !ok) return tl::unexpected(std::move(ok).error());
  return out;
}

}  // namespace

Result<Picture> readPicture(std::string_view svg, const std::string& file, double from_mm, double to_mm,
                            const std::vector<std::string>& regions) {
  const auto elements = readSvg(svg);
  if (!elements) return base::inFile(elements.error(), file);
  auto out = readElements(*elements, from_mm, to_mm, regions);
  if (!out) return base::inFile(std::move(out).error(), file);
  out->file = file;
  out->svg = svg;
  return out;
}

Result<void> readPictures(Procedure& procedure) {
  const fuzzy::Variable& way = procedure.wayInput();
  std::vector<std::string> regions;
  for (const auto& term : way.terms) regions.push_back(term.id);
  for (Picture& picture : procedure.pictures) {
    const study::ItemCondition pose = picture.pose;
    const bool known = std::any_of(procedure.inputs.begin(), procedure.inputs.end(), [&](const auto& input) {
      return input.id == pose.input && fuzzy::findTerm(input.terms, pose.term) != nullptr;
    });
    if (!pose.input.empty() && !known) {
      return fail(ErrorCode::kReference, "pose of " + base::quoted(picture.file),
                  base::quoted(pose.input + " " + pose.term), "an input of the procedure and one of its words");
    }
    TACTUS_TRY(picture, readPicture(procedure.files.at(picture.file), picture.file, way.min, way.max, regions));
    picture.pose = pose;
  }
  for (const OtherView& view : procedure.other_views) {
    if (const auto ok = readSvg(procedure.files.at(view.file)); !ok) return base::inFile(ok.error(), view.file);
  }
  return {};
}

Point placeAt(const Picture& picture, double place_mm) {
  const auto& mm = picture.way_mm;
  const double at = std::clamp(place_mm, mm.front(), mm.back());
  const auto next = std::upper_bound(mm.begin() + 1, mm.end() - 1, at);
  const auto i = static_cast<std::size_t>(next - mm.begin());
  const double share = (at - mm[i - 1]) / (mm[i] - mm[i - 1]);
  const Point& a = picture.way[i - 1];
  const Point& b = picture.way[i];
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

std::vector<Picture> picturesOf(const Procedure& procedure) {
  if (!procedure.pictures.empty()) return procedure.pictures;
  constexpr double kWidth = 600, kHeight = 150, kTop = 50, kBottom = 100;
  const fuzzy::Variable& way = procedure.wayInput();
  const auto x = [&](double mm) { return std::round(kWidth * (mm - way.min) / (way.max - way.min) * 10) / 10; };
  const auto number = [](double value) { return base::formatNumber(value); };
  std::string shapes;
  std::vector<std::string> ids;
  for (const auto& term : way.terms) {
    // From the middle of the overlap with the region before to that with the next.
    const double from = x(std::clamp((term.points[0] + term.points[1]) / 2, way.min, way.max));
    const double to = x(std::clamp((term.points[2] + term.points[3]) / 2, way.min, way.max));
    shapes += "<path id=\"region_" + term.id + "\" d=\"M" + number(from) + " " + number(kTop) + "H" + number(to) + "V" +
              number(kBottom) + "H" + number(from) + "Z\" fill=\"" + (ids.size() % 2 == 0 ? "#F3E3DA" : "#E9D2C5") +
              "\" stroke=\"#C99B82\" stroke-width=\"1\"/>";
    ids.push_back(term.id);
  }
  const std::string middle = number((kTop + kBottom) / 2);
  const std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-20 0 " + number(kWidth + 40) + " " +
                          number(kHeight) + "\">" + shapes + "<path id=\"way\" d=\"M0 " + middle + "H" +
                          number(kWidth) + "\" fill=\"none\" stroke=\"#B98A70\" stroke-width=\"1\"/></svg>";
  auto made = readPicture(svg, "bar of regions", way.min, way.max, ids);
  return made ? std::vector<Picture>{*std::move(made)} : std::vector<Picture>{};
}

std::vector<std::string> regionsOf(const Procedure& procedure, const study::Form& form) {
  const std::string& way = procedure.wayInput().id;
  std::vector<std::string> out;
  const TermSet* const set = procedure.wayTerms(form.depth_terms);
  for (const auto& term : set != nullptr ? set->terms : procedure.wayInput().terms) {
    const study::ItemCondition region{way, term.id};
    const bool asked = std::any_of(form.items.begin(), form.items.end(), [&](const study::FormItem& item) {
      return std::find(item.conditions.begin(), item.conditions.end(), region) != item.conditions.end();
    });
    if (asked) out.push_back(term.id);
  }
  return out;
}

}  // namespace tactus::procedure
