#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/procedure/procedure.h"

namespace tactus::procedure {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr int kStepsOfCurve = 16;
constexpr std::string_view kSpaces = " \t\r\n";

struct SvgElement {
  std::string name;  ///< in lower case
  std::vector<std::pair<std::string, std::string>> attributes;
  bool moved = false;  ///< it, or an element around it, has a transform

  const std::string* attribute(std::string_view wanted) const {
    for (const auto& [key, value] : attributes) {
      if (key == wanted) return &value;
    }
    return nullptr;
  }
};

/// The elements of an XML text in its order.
class Elements {
 public:
  explicit Elements(std::string_view text) : text_(text) {}

  Result<std::vector<SvgElement>> read() {
    std::vector<SvgElement> out;
    while ((at_ = text_.find('<', at_)) != std::string_view::npos) {
      if (text_.substr(at_).starts_with("<!--")) {
        if (!skipTo("-->")) return broken("a comment without its end");
      } else if (text_.substr(at_).starts_with("<?")) {
        if (!skipTo("?>")) return broken("an instruction without its end");
      } else if (text_.substr(at_).starts_with("<!")) {
        return broken("a document type or an entity");
      } else if (text_.substr(at_).starts_with("</")) {
        if (!moved_.empty()) moved_.pop_back();
        if (!skipTo(">")) return broken("a tag without its end");
      } else if (!readTag(out)) {
        return broken("a tag without its end");
      }
    }
    return out;
  }

 private:
  static tl::unexpected<base::Error> broken(std::string found) {
    return fail(ErrorCode::kSyntax, {}, std::move(found), "an SVG picture of elements alone");
  }

  bool skipTo(std::string_view end) {
    const auto found = text_.find(end, at_);
    if (found == std::string_view::npos) return false;
    at_ = found + end.size();
    return true;
  }

  void skipSpaces() { at_ = std::min(text_.find_first_not_of(kSpaces, at_), text_.size()); }

  bool readTag(std::vector<SvgElement>& out) {
    ++at_;
    SvgElement element;
    const auto name_end = text_.find_first_of(" \t\r\n/>", at_);
    if (name_end == std::string_view::npos) return false;
    element.name = base::lowered(text_.substr(at_, name_end - at_));
    at_ = name_end;
    while (true) {
      skipSpaces();
      if (at_ >= text_.size()) return false;
      if (text_[at_] == '>' || text_[at_] == '/') break;
      const auto key_end = text_.find_first_of("= \t\r\n/>", at_);
      if (key_end == std::string_view::npos) return false;
      const std::string key(text_.substr(at_, key_end - at_));
      at_ = key_end;
      skipSpaces();
      if (at_ >= text_.size() || text_[at_] != '=') return false;
      ++at_;
      skipSpaces();
      if (at_ >= text_.size() || (text_[at_] != '"' && text_[at_] != '\'')) return false;
      const auto value_end = text_.find(text_[at_], at_ + 1);
      if (value_end == std::string_view::npos) return false;
      element.attributes.emplace_back(key, text_.substr(at_ + 1, value_end - at_ - 1));
      at_ = value_end + 1;
    }
    element.moved = (!moved_.empty() && moved_.back()) || element.attribute("transform") != nullptr;
    const bool alone = text_[at_] == '/';
    if (!skipTo(">")) return false;
    if (!alone) moved_.push_back(element.moved);
    out.push_back(std::move(element));
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<bool> moved_;  ///< of each open element
};

/// What must not be in a picture that came from elsewhere; nothing if it may be shown.
std::optional<std::string> danger(const SvgElement& element) {
  for (const std::string_view name : {"script", "foreignobject", "iframe", "image", "set", "animate"}) {
    if (element.name == name || element.name.ends_with(':' + std::string(name))) return "an element " + element.name;
  }
  for (const auto& [key, value] : element.attributes) {
    const std::string name = base::lowered(key);
    const std::string text = base::lowered(value);
    if (name.starts_with("on")) return "an event " + key;
    const bool link = name == "href" || name.ends_with(":href");
    if (link && !base::trimmed(text).starts_with('#')) return "a link to " + base::quoted(value);
  }
  return std::nullopt;
}

/// Whether a style in `text`, in lower case, reaches another file.
bool hasLinkedStyle(std::string_view text) {
  for (auto at = text.find("url("); at != std::string_view::npos; at = text.find("url(", at + 1)) {
    const auto inside = text.find_first_not_of(" '\"", at + 4);
    if (inside == std::string_view::npos || text[inside] != '#') return true;
  }
  return text.find("@import") != std::string_view::npos;
}

/// The elements of a picture in its order, the first is the `svg`. It is no validator: what it passes over, the one who
/// draws the picture refuses. Refused: what could run, load another file or name an entity.
Result<std::vector<SvgElement>> readSvg(std::string_view text) {
  if (!base::isUtf8(text)) return fail(ErrorCode::kSyntax, {}, "bytes that are not UTF-8", "an SVG picture");
  if (hasLinkedStyle(base::lowered(text)))
    return fail(ErrorCode::kValue, {}, "a style that links to another file", "a picture that needs no other file");
  TACTUS_TRY(auto elements, Elements(text).read());
  if (elements.empty() || elements.front().name != "svg")
    return fail(ErrorCode::kSyntax, {}, "no element svg", "an SVG picture");
  for (const SvgElement& element : elements) {
    if (auto found = danger(element)) {
      return fail(ErrorCode::kValue, {}, *std::move(found),
                  "shapes, text and colours alone: no script, event, image or link to another file");
    }
  }
  return elements;
}

/// The numbers of a list that is separated by spaces and commas, where a sign or a second point begins a number too.
std::optional<std::vector<double>> svgNumbers(std::string_view text) {
  std::vector<double> out;
  for (std::size_t at = 0; at < text.size();) {
    if (kSpaces.find(text[at]) != std::string_view::npos || text[at] == ',') {
      ++at;
      continue;
    }
    std::size_t end = at;
    bool point = false;
    for (; end < text.size(); ++end) {
      const char c = text[end];
      const bool exponent = end > at && (text[end - 1] == 'e' || text[end - 1] == 'E');
      if (base::isDigit(c) || c == 'e' || c == 'E') continue;
      if ((c == '-' || c == '+') && (end == at || exponent)) continue;
      if (c != '.' || point) break;
      point = true;
    }
    if (end > at && text[at] == '+') ++at;
    const auto number = base::parseNumber(text.substr(at, end - at));
    if (!number || !std::isfinite(*number)) return std::nullopt;
    out.push_back(*number);
    at = end;
  }
  return out;
}

/// The points of a path, and which of them are nodes.
struct SvgLine {
  std::vector<Point> points;
  std::vector<std::size_t> nodes;
};

/// Follows the commands of a path.
class PathReader {
 public:
  std::optional<SvgLine> read(std::string_view d) {
    for (std::size_t at = d.find_first_not_of(kSpaces); at != std::string_view::npos && at < d.size();) {
      const char command = d[at];
      if (!base::isLetter(command)) return std::nullopt;
      const auto end = std::min(d.find_first_of("MmLlHhVvCcSsQqTtAaZz", at + 1), d.size());
      const auto numbers = svgNumbers(d.substr(at + 1, end - at - 1));
      if (!numbers || !follow(command, *numbers)) return std::nullopt;
      at = end;
    }
    if (line_.points.size() < 2) return std::nullopt;
    return std::move(line_);
  }

 private:
  Point here() const { return line_.points.empty() ? Point{} : line_.points.back(); }

  void node(Point to) {
    line_.points.push_back(to);
    line_.nodes.push_back(line_.points.size() - 1);
  }

  void cubic(Point a, Point b, Point to) {
    const Point from = here();
    for (int step = 1; step <= kStepsOfCurve; ++step) {
      const double t = static_cast<double>(step) / kStepsOfCurve;
      const double s = 1 - t;
      const double w0 = s * s * s, w1 = 3 * s * s * t, w2 = 3 * s * t * t, w3 = t * t * t;
      const Point at{w0 * from.x + w1 * a.x + w2 * b.x + w3 * to.x, w0 * from.y + w1 * a.y + w2 * b.y + w3 * to.y};
      if (step < kStepsOfCurve) line_.points.push_back(at);
    }
    node(to);
    handle_ = b;
  }

  void quadratic(Point a, Point to) {
    const Point from = here();
    cubic({from.x + 2.0 / 3 * (a.x - from.x), from.y + 2.0 / 3 * (a.y - from.y)},
          {to.x + 2.0 / 3 * (a.x - to.x), to.y + 2.0 / 3 * (a.y - to.y)}, to);
    handle_ = a;
  }

  Point mirrored() const { return {2 * here().x - handle_.x, 2 * here().y - handle_.y}; }

  bool follow(char command, const std::vector<double>& n) {
    const bool relative = command >= 'a';
    const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
    static constexpr std::pair<char, std::size_t> kCounts[] = {{'M', 2}, {'L', 2}, {'H', 1}, {'V', 1}, {'C', 6},
                                                               {'S', 4}, {'Q', 4}, {'T', 2}, {'Z', 0}};
    const auto* const count =
        std::find_if(std::begin(kCounts), std::end(kCounts), [kind](const auto& one) { return one.first == kind; });
    if (count == std::end(kCounts)) return false;
    if (count->second == 0) return n.empty();  // closed: the way and an outline end where they began
    if (n.empty() || n.size() % count->second != 0) return false;
    for (std::size_t i = 0; i < n.size(); i += count->second) {
      const Point from = relative ? here() : Point{};
      const auto point = [&](std::size_t k) { return Point{from.x + n[i + k], from.y + n[i + k + 1]}; };
      const bool smooth =
          (kind == 'S' && (last_ == 'C' || last_ == 'S')) || (kind == 'T' && (last_ == 'Q' || last_ == 'T'));
      if (!smooth) handle_ = here();
      switch (kind) {
        case 'M':
          if (!line_.points.empty() && i == 0) return false;  // one line, not two
          node(point(0));
          break;
        case 'L': node(point(0)); break;
        case 'H': node({from.x + n[i], here().y}); break;
        case 'V': node({here().x, from.y + n[i]}); break;
        case 'C': cubic(point(0), point(2), point(4)); break;
        case 'S': cubic(mirrored(), point(0), point(2)); break;
        case 'Q': quadratic(point(0), point(2)); break;
        default: quadratic(mirrored(), point(0)); break;
      }
      last_ = kind;
    }
    return true;
  }

  SvgLine line_;
  Point handle_;
  char last_ = 'M';
};

const SvgElement* withId(const std::vector<SvgElement>& elements, std::string_view id) {
  for (const SvgElement& element : elements) {
    const std::string* const own = element.attribute("id");
    if (own != nullptr && *own == id) return &element;
  }
  return nullptr;
}

Result<std::pair<std::string, SvgLine>> pathWithId(const std::vector<SvgElement>& elements, const std::string& id) {
  const std::string place = "path " + base::quoted(id);
  const SvgElement* const element = withId(elements, id);
  if (element == nullptr) return fail(ErrorCode::kReference, place, "no element with this id", "a path");
  const std::string* const d = element->attribute("d");
  if (element->name != "path" || d == nullptr)
    return fail(ErrorCode::kSchema, place, "an element " + base::quoted(element->name), "a path with its 'd'");
  if (element->moved) {
    return fail(ErrorCode::kValue, place, "a path that is moved by a 'transform'",
                "a path whose numbers are those of the view box");
  }
  auto line = PathReader().read(*d);
  if (!line) {
    return fail(ErrorCode::kSyntax, place, base::quoted(*d),
                "one line of moves, lines and curves (M, L, H, V, C, S, Q, T, Z), no arcs");
  }
  return std::pair(*d, *std::move(line));
}

/// The length of the line up to each point.
std::vector<double> lengthsOf(const std::vector<Point>& line) {
  std::vector<double> out(line.size(), 0);
  for (std::size_t i = 1; i < line.size(); ++i)
    out[i] = out[i - 1] + std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return out;
}

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

std::vector<Point> pointsOf(std::string_view path) {
  auto line = PathReader().read(path);
  return line ? std::move(line->points) : std::vector<Point>();
}

}  // namespace tactus::procedure
