#include "app/report/markup.h"

#include "core/base/text.h"

namespace tactus::report {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Name of the badge's style in the page's style sheet.
std::string_view cssClass(Badge badge) noexcept {
  switch (badge) {
    case Badge::kPublished:
      return "published";
    case Badge::kSimulated:
      return "simulated";
    case Badge::kComputed:
      return "computed";
    case Badge::kByConstruction:
      return "construction";
    case Badge::kYes:
      return "yes";
    case Badge::kNo:
      return "no";
    case Badge::kNotApplicable:
      return "none";
  }
  return "none";
}

}  // namespace

std::string escaped(std::string_view text) {
  const bool utf8 = base::isUtf8(text);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      case '\t':
      case '\n':
        out += c;
        break;
      default:
        if (byte < 0x20 || byte == 0x7F || (byte >= 0x80 && !utf8)) {
          out += kReplacement;
        } else {
          out += c;
        }
    }
  }
  return out;
}

std::string_view name(Badge badge) noexcept {
  switch (badge) {
    case Badge::kPublished:
      return "published";
    case Badge::kSimulated:
      return "simulated";
    case Badge::kComputed:
      return "computed";
    case Badge::kByConstruction:
      return "by construction";
    case Badge::kYes:
      return "yes";
    case Badge::kNo:
      return "no";
    case Badge::kNotApplicable:
      return "not asked";
  }
  return "";
}

Markup badge(Badge badge) {
  std::string html = "<span class=\"badge ";
  html += cssClass(badge);
  html += "\">";
  html += name(badge);
  html += "</span>";
  return Markup::raw(std::move(html));
}

Markup badges(std::initializer_list<Badge> list) {
  Markup out;
  for (const Badge each : list) {
    if (!out.empty()) out += " ";
    out += badge(each);
  }
  return out;
}

Markup strong(const Markup& text) { return Markup::raw("<strong>" + text.html() + "</strong>"); }

Markup muted(const Markup& text) { return Markup::raw("<span class=\"muted\">" + text.html() + "</span>"); }

}  // namespace tactus::report
