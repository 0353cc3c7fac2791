#include "app/report/markup.h"

namespace tactus::report {

namespace {

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
