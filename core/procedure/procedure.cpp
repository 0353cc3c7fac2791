#include "core/procedure/procedure.h"

#include <algorithm>
#include <cmath>

#include "core/base/files/checksums.h"
#include "core/base/text.h"

namespace tactus::procedure {

std::string textIn(const Texts& texts, std::string_view language) {
  for (const std::string_view wanted : {language, std::string_view("en")}) {
    const auto found = texts.find(std::string(wanted));
    if (found != texts.end()) return found->second;
  }
  return texts.empty() ? std::string() : texts.begin()->second;
}

std::size_t Procedure::way() const { return fuzzy::wayOf(inputs).value_or(0); }
std::optional<std::size_t> Procedure::rate() const { return fuzzy::rateOf(inputs); }

const fuzzy::Variable* Procedure::rateInput() const {
  const auto found = rate();
  return found ? &inputs[*found] : nullptr;
}

std::vector<std::string> Procedure::inputIds() const {
  std::vector<std::string> out;
  for (const auto& input : inputs) out.push_back(input.id);
  return out;
}

const TermSet* Procedure::wayTerms(std::string_view set) const {
  const auto found =
      std::find_if(way_terms.begin(), way_terms.end(), [&](const TermSet& one) { return one.id == set; });
  return found == way_terms.end() ? nullptr : &*found;
}

const study::Form* Procedure::form(std::string_view form_id) const {
  const auto found =
      std::find_if(forms.begin(), forms.end(), [&](const study::Form& one) { return one.id == form_id; });
  return found == forms.end() ? nullptr : &*found;
}

std::string Procedure::titleIn(std::string_view language) const { return textIn(title, language); }

std::string packSha256(const PackFiles& files) {
  std::string list;
  for (const auto& [path, bytes] : files) list += base::sha256(bytes) + "  " + path + "\n";
  return base::sha256(list);
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
