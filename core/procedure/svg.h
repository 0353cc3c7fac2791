// The part of SVG that the pictures of a pack are read from: elements with their attributes, and paths of moves, lines
// and curves.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/procedure/procedure.h"

namespace tactus::procedure {

struct SvgElement {
  std::string name;  ///< in lower case
  std::vector<std::pair<std::string, std::string>> attributes;
  bool moved = false;  ///< it, or an element around it, has a transform

  const std::string* attribute(std::string_view wanted) const;
};

/// The elements of a picture in its order, the first is the `svg`. It is no validator: what it passes over, the one who
/// draws the picture refuses. Refused: what could run, load another file or name an entity.
base::Result<std::vector<SvgElement>> readSvg(std::string_view text);

/// The numbers of a list that is separated by spaces and commas, where a sign or a second point begins a number too.
std::optional<std::vector<double>> svgNumbers(std::string_view text);

/// The points of a path, and which of them are nodes.
struct SvgLine {
  std::vector<Point> points;
  std::vector<std::size_t> nodes;
};

/// Null if no element has the id `id`.
const SvgElement* withId(const std::vector<SvgElement>& elements, std::string_view id);

/// The path with the id `id`: its `d` and its line. Refused: no such path, one that is moved by a transform, one of
/// several lines or with arcs.
base::Result<std::pair<std::string, SvgLine>> pathWithId(const std::vector<SvgElement>& elements,
                                                         const std::string& id);

/// The length of the line up to each point.
std::vector<double> lengthsOf(const std::vector<Point>& line);

}  // namespace tactus::procedure
