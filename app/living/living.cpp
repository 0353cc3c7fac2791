#include "app/living/living.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "app/figures/colors.h"
#include "core/analysis/check_points.h"
#include "core/base/files/checksums.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/exchange/js_source.h"
#include "core/exchange/tube_source.h"
#include "core/render/tube_checks.h"

namespace tactus::living {

// Embedded from page/.
std::string_view livingStyle();
std::string_view firstScript();
std::string_view numbersScript();
std::string_view kitScript();
std::string_view panelsScript();
std::string_view tubeScript();
std::string_view wordsScript();
std::string_view startScript();
std::string_view lastScript();

namespace {

using base::JsonWriter;
constexpr auto kInline = JsonWriter::Layout::kInline;
constexpr int kRampColors = 33;

/// A script as the text of its element, in HTML and in XML. Only a text of the model can hold what is replaced.
std::string inPage(std::string script) {
  script = base::replaced(std::move(script), {{"]]>", "]]\\u003e"}, {"<!--", "<\\!--"}, {"</", "<\\/"}});
  return "/*<![CDATA[*/\n" + std::move(script) + "/*]]>*/";
}

/// `x` with few digits: a thousandth of the power of ten below the range.
std::string shortNumber(const fuzzy::Variable& variable, double x) {
  constexpr int kDigits = 3;
  constexpr int kMostDecimals = 9;
  const int decimals = kDigits - static_cast<int>(std::floor(std::log10(variable.max - variable.min)));
  if (decimals < 0 || decimals > kMostDecimals) return base::formatNumber(x);
  std::string text = base::formatFixed(x, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

/// Points and the evaluator's forces there, one row for each: `0.5,45,132,110,0.61;…`; `-` where no rule fires.
std::string checksOf(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled) {
  std::string out;
  for (std::vector<double> point : analysis::checkPoints(model)) {
    if (!out.empty()) out += ';';
    for (std::size_t i = 0; i < point.size(); ++i) {
      const std::string text = shortNumber(model.inputs[i], point[i]);
      point[i] = base::parseNumber(text).value_or(point[i]);
      out += text + ',';
    }
    const fuzzy::Evaluation force = compiled.evaluate(point);
    out += force.fired ? base::formatNumber(force.force_n) : "-";
  }
  return out;
}

/// The index, or -1.
int orNone(const std::optional<std::size_t>& index) { return index ? static_cast<int>(*index) : -1; }

void addColors(const fuzzy::ForceModel& model, JsonWriter& json) {
  json.key("colors").beginArray(kInline);
  for (const std::size_t number : figures::expertNumbers(model.experts))
    json.value(figures::hex(figures::expertColor(number)));
  json.endArray().key("ramp").beginArray(kInline);
  for (int i = 0; i < kRampColors; ++i)
    json.value(figures::hex(figures::forceRamp(static_cast<double>(i) / (kRampColors - 1))));
  json.endArray().key("words").beginObject(kInline);
  for (std::size_t t = 0; t < model.output.terms.size(); ++t)
    json.key(model.output.terms[t].id).value(figures::hex(figures::termColor(model.output, model.output.terms, t)));
  json.endObject();
}

/// What the scripts need beside the model; JSON in which no text ends the script, in HTML and in XML.
std::string contentOf(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled) {
  JsonWriter json;
  json.beginObject().key("region").value(orNone(fuzzy::wayOf(model.inputs)));
  json.key("speed").value(orNone(fuzzy::rateOf(model.inputs)));
  addColors(model, json);
  json.key("tube");
  if (const auto tube = render::tubeInputs(model)) {
    json.beginObject(kInline).key("depth").value(tube->depth).key("offset");
    json.value(model.renderer.value_or(fuzzy::RendererParameters()).depth_offset_mm)
        .key("conditions")
        .beginArray(kInline);
    for (const std::size_t input : tube->conditions) json.value(input);
    json.endArray().endObject();
  } else {
    json.null();
  }
  return base::replaced(json.key("checks").value(checksOf(model, compiled)).endObject().text(),
                        {{"<", "\\u003c"}, {"&", "\\u0026"}, {">", "\\u003e"}});
}

std::string panelScripts() {
  std::string out = "(() => {\n'use strict';\n";
  for (const std::string_view part : {kitScript(), panelsScript(), tubeScript(), wordsScript(), startScript()})
    out += part;
  return out + "})();\n";
}

}  // namespace

std::optional<Section> sectionOf(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, bool simulated,
                                 const exchange::Origin& origin) {
  if (model.experts.empty() || model.experts.size() > kMostExperts) return std::nullopt;
  const std::string content = contentOf(model, compiled);
  std::vector<std::string> scripts = {inPage(std::string(firstScript())), inPage(exchange::jsForce(model, origin))};
  if (const auto tube = exchange::jsTube(model, origin)) scripts.push_back(inPage(*tube));
  scripts.push_back(content);
  for (std::string script : {std::string(numbersScript()), panelScripts(), std::string(lastScript())})
    scripts.push_back(inPage(std::move(script)));

  std::string elements;
  for (const std::string& script : scripts) {
    elements +=
        &script == &scripts[scripts.size() - 4] ? "<script type=\"application/json\" id=\"living-data\">" : "<script>";
    elements += script + "</script>\n";
  }
  std::string punctures;
  for (const std::string& event : fuzzy::eventTexts(model)) {
    punctures += "<p class=\"living-hint\">Puncture: " + base::xmlEscaped(event) +
                 ", once in a stroke. Only the tube has it; all other forces here are without it.</p>\n";
  }
  char checksum[9];
  std::snprintf(checksum, sizeof checksum, "%08x", base::crc32(base::joined(scripts, "\n")));
  Section out;
  out.style = livingStyle();
  out.html = "<div id=\"living\" class=\"living\" data-crc32=\"" + std::string(checksum) +
             "\">\n<p id=\"living-state\" class=\"living-state\" role=\"status\">This page can only be read here: its "
             "scripts are off, so nothing was checked.</p>\n<p class=\"living-hint\">" +
             (simulated ? "<span class=\"badge simulated\">simulated</span> Data of this model are simulated, not "
                          "measured on a person. "
                        : "") +
             "Everything here is computed in this page, from the model inside it. Nothing is loaded and nothing is "
             "sent.</p>\n" +
             punctures + "<div id=\"living-app\" hidden=\"hidden\"></div>\n" + elements + "</div>\n";
  return out;
}

}  // namespace tactus::living
