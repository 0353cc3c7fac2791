#include "core/procedure/svg.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace tactus::procedure {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr int kStepsOfCurve = 16;
constexpr std::string_view kSpaces = " \t\r\n";

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

}  // namespace

const std::string* SvgElement::attribute(std::string_view wanted) const {
  for (const auto& [key, value] : attributes) {
    if (key == wanted) return &value;
  }
  return nullptr;
}

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

std::vector<Point> pointsOf(std::string_view path) {
  auto line = PathReader().read(path);
  return line ? std::move(line->points) : std::vector<Point>();
}

std::vector<double> lengthsOf(const std::vector<Point>& line) {
  std::vector<double> out(line.size(), 0);
  for (std::size_t i = 1; i < line.size(); ++i)
    out[i] = out[i - 1] + std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return out;
}

}  // namespace tactus::procedure
