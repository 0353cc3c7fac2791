#include "core/exchange/tube_source.h"

#include <algorithm>
#include <numbers>
#include <regex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/exchange/c_parts.h"
#include "core/fuzzy/membership.h"
#include "core/render/insertion_renderer.h"
#include "core/render/tube_checks.h"

namespace tactus::exchange {
namespace {

/// The numbers of the renderer under the names that both languages use.
std::vector<std::pair<std::string, double>> numbersOf(const fuzzy::ForceModel& model,
                                                      const render::TubeInputs& inputs) {
  const fuzzy::RendererParameters friction = model.renderer.value_or(fuzzy::RendererParameters());
  return {{"K", friction.stiffness_n_mm},
          {"MU", friction.damping_n_s_mm},
          {"TAU", friction.breakaway_ratio},
          {"RHO", friction.withdrawal_ratio},
          {"RESTICK_MM", friction.restick_mm},
          {"RELAXATION_S", friction.relaxation_s},
          {"AGEING_S", friction.ageing_s},
          {"STICK_SPEED_MM_S", friction.stick_speed_mm_s},
          {"STICK_TIME_S", friction.stick_time_s},
          {"FILTER_S", 1 / (2 * std::numbers::pi * friction.velocity_filter_hz)},
          {"SLEW_N_S", friction.slew_n_s},
          {"OFFSET_MM", friction.depth_offset_mm},
          {"DEEPEST_MM", model.inputs[inputs.depth].max - friction.depth_offset_mm},
          {"CAP_N", render::kTubeCapN},
          {"ENGAGE_MM_S", render::kEngageSpeedMmS},
          {"RELEASE_S", render::kReleaseFadeS},
          {"DAMPING_IN_S", render::kDampingFadeInS},
          {"DAMPING_OUT_S", render::kDampingFadeOutS},
          {"DAMPING_SHARE", render::kLargestDampingShare},
          {"TUBE_OUT_S", render::kTubeOutS},
          {"FARTHEST_MM", render::kFarthestMm},
          {"SHORTEST_S", render::kShortestTickS},
          {"LONGEST_S", render::kLongestTickS},
          {"SMALLEST", render::kSmallest}};
}

/// The numbers of the model's events, likewise.
std::vector<std::pair<std::string, double>> eventNumbersOf(const fuzzy::ForceModel& model,
                                                           const render::TubeInputs& inputs) {
  if (model.events.empty()) return {};
  const fuzzy::Variable& way = model.inputs[inputs.depth];
  const double offset_mm = model.renderer.value_or(fuzzy::RendererParameters()).depth_offset_mm;
  std::vector<std::pair<std::string, double>> out = {{"WAY_MIN_MM", way.min}, {"WAY_MAX_MM", way.max}};
  for (std::size_t e = 0; e < model.events.size(); ++e) {
    const fuzzy::Term& term = *fuzzy::findTerm(way.terms, model.events[e].term);
    const std::string name = "EVENT_" + std::to_string(e + 1);
    out.emplace_back(name + "_MM", fuzzy::endOfCore(way, term) - offset_mm);
    out.emplace_back(name + "_SHARE", model.events[e].share);
  }
  return out;
}

/// The body in JavaScript: declarations lose their types, a state is an object.
std::string inJavaScript(std::string_view body) {
  std::string out;
  for (std::size_t from = 0; from < body.size();) {
    const std::size_t end = std::min(body.find('\n', from), body.size());
    std::string line(body.substr(from, end - from));
    from = end + 1;
    static const std::regex kFunction("^(static )?(double|int|void) (\\w+)\\((.*)$");
    static const std::regex kParameter("(const )?(tube_state|double|int) \\*?(\\w+)(?=[,)])");
    static const std::regex kConstant("^( +)const (double|int) ");
    static const std::regex kVariable("^( +)(double|int) ");
    if (std::regex_search(line, kFunction)) {
      line = std::regex_replace(line, kFunction, "function $3($4");
      line = std::regex_replace(line, kParameter, "$3");
    }
    line = std::regex_replace(line, kConstant, "$1const ");
    line = std::regex_replace(line, kVariable, "$1let ");
    out += base::replaced(std::move(line), {{"t->", "t."}, {" == ", " === "}, {" != ", " !== "}}) + "\n";
  }
  return base::replaced(std::move(out),
                        {{"tube_step(", "tubeStep("}, {"tube_place(", "tubePlace("}, {"tube_change(", "tubeChange("}});
}

/// What both languages fill in.
struct Filling {
  std::string origin;       ///< a line of a comment, or nothing
  std::string conditions;   ///< a comment of one line each
  std::string places;       ///< of the inputs of the model, in C
  std::string shares;       ///< of the events, in C
  std::string counts;       ///< of the events, in C
  bool trapezoids = false;  ///< some event is at a trapezoid or triangle
  bool bells = false;       ///< some event is at a Gaussian
};

/// What each event of the model adds to the text.
void addEvents(const fuzzy::ForceModel& model, const fuzzy::Variable& way, Filling& out) {
  for (std::size_t e = 0; e < model.events.size(); ++e) {
    const auto f = fuzzy::MembershipFunction::of(*fuzzy::findTerm(way.terms, model.events[e].term));
    const std::string name = "EVENT_" + std::to_string(e + 1);
    const std::string reached = std::string(e > 0 ? "\n" : "") + "  if (t->deepest_mm >= " + name + "_MM) ";
    (f.gaussian ? out.bells : out.trapezoids) = true;
    std::string membership = f.gaussian ? "bell(x, " + number(f.mean) + ", " + number(f.sigma) + ")" : "trapezoid(x";
    if (!f.gaussian) {
      for (const double point : {f.a, f.b, f.c, f.d}) membership += ", " + number(point);
      membership += ")";
    }
    out.shares += reached + "left *= 1.0 - " + name + "_SHARE * " + membership + ";";
    out.counts += reached + "done += 1;";
  }
}

/// `text` with the lines for this model, and what it fills in.
std::string linesOf(std::string_view text, const Filling& filling) {
  const std::pair<std::string_view, bool> kMarks[] = {
      {"@EVENTS@", !filling.counts.empty()}, {"@TRAPEZOID@", filling.trapezoids}, {"@BELL@", filling.bells}};
  std::string out;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size() - 1) + 1;
    std::string_view line = text.substr(from, end - from);
    from = end;
    const auto mark = std::find_if(std::begin(kMarks), std::end(kMarks),
                                   [&](const auto& one) { return line.starts_with(one.first); });
    if (mark != std::end(kMarks)) line = mark->second ? line.substr(mark->first.size()) : std::string_view();
    out += line;
  }
  return base::replaced(out, {{"@SHARES@", filling.shares}, {"@COUNTS@", filling.counts}});
}

Filling fillingOf(const fuzzy::ForceModel& model, const render::TubeInputs& inputs, const Origin& origin) {
  Filling out;
  const auto place = [&](std::size_t input, const std::string& value) {
    out.places += (out.places.empty() ? "" : "\n") + ("  inputs[" + std::to_string(input) + "] = " + value + ";");
  };
  for (std::size_t c = 0; c < inputs.conditions.size(); ++c) {
    const fuzzy::Variable& input = model.inputs[inputs.conditions[c]];
    out.conditions += " *   " + comment(input.id) + ", " + base::formatNumber(input.min) + " to " +
                      base::formatNumber(input.max) + " " + comment(input.unit) + "\n";
    place(inputs.conditions[c], "t->conditions[" + std::to_string(c) + "]");
  }
  place(inputs.depth, "depth_mm");
  if (inputs.speed) place(*inputs.speed, "speed_mm_s");
  addEvents(model, model.inputs[inputs.depth], out);
  out.origin = origin.model_sha256.empty() ? std::string() : " * " + comment(originText(origin)) + "\n";
  out.conditions =
      out.conditions.empty() ? " * There are no conditions.\n" : " * Conditions, in this order:\n" + out.conditions;
  return out;
}

std::string numbersText(const fuzzy::ForceModel& model, const render::TubeInputs& inputs, const std::string& declare) {
  std::string out;
  for (const auto& numbers : {numbersOf(model, inputs), eventNumbersOf(model, inputs)}) {
    for (const auto& [name, value] : numbers) out += declare + name + " = " + number(value) + ";\n";
  }
  return out;
}

}  // namespace

base::Result<TubeSource> cTube(const fuzzy::ForceModel& model, const Origin& origin) {
  TACTUS_TRY(const auto inputs, render::tubeInputs(model));
  const Filling filling = fillingOf(model, inputs, origin);
  TubeSource out;
  out.header =
      "/* The tube of " + comment(model.name) +
      ", written by Tactus: what a hand feels that pushes it in, stroke by stroke. C99, with force_model.c beside it;\n"
      " * no other library, no allocation, no lock, bounded time. Lengths are mm, times s, forces N.\n" +
      filling.origin + filling.conditions +
      " *\n *   tube_state tube;\n *   tube_start(&tube, conditions);\n"
      " *   for (;;) { force_n = tube_step(&tube, position_mm, held, dt_s); ... }\n */\n" +
      base::replaced(linesOf(kTubeHeader, filling), {{"@CONDITIONS@", std::to_string(inputs.conditions.size())}});
  out.source = "/* The tube of " + comment(model.name) +
               ": see tube.h. The numbers in parentheses are those of docs/renderer.md. Written by Tactus; edit the\n"
               " * model, not this file. */\n#include \"tube.h\"\n\n#include \"force_model.h\"\n\n" +
               std::string(filling.bells ? "#include <math.h>\n\n" : "") +
               "/* A product and a sum stay two operations, so that every processor gives the same bits. */\n"
               "#if defined(__GNUC__) && !defined(__clang__)\n#pragma GCC optimize(\"fp-contract=off\")\n"
               "#elif defined(__clang__)\n#pragma STDC FP_CONTRACT OFF\n#endif\n\n" +
               numbersText(model, inputs, "static const double ") +
               base::replaced(std::string(kTubeStartInC),
                              {{"@INPUTS@", filling.places + (inputs.speed ? "" : "\n  (void)speed_mm_s;")}}) +
               linesOf(kTubeBody, filling);
  return out;
}

base::Result<std::string> jsTube(const fuzzy::ForceModel& model, const Origin& origin) {
  TACTUS_TRY(const auto inputs, render::tubeInputs(model));
  const Filling filling = fillingOf(model, inputs, origin);
  return forAPage(
      "/* The tube of " + comment(model.name) +
      ", written by Tactus: what a hand feels that pushes it in, stroke by stroke. Plain JavaScript,\n"
      " * with force_model.js beside it: a module for Node, a script for a page. Lengths are mm, times s, forces "
      "N.\n"
      " * The numbers in parentheses are those of docs/renderer.md.\n" +
      filling.origin + filling.conditions +
      " *\n *   const tube = tubeStart(conditions);\n"
      " *   const force_n = tubeStep(tube, position_mm, held, dt_s);   what else is felt: tube.depth_mm, "
      "tube.phase, "
      "...\n */\n"
      "(function () {\n'use strict';\n"
      "const forceModel = typeof module === 'object' && module.exports ? require('./force_model.js').forceModel\n"
      "                                                                : globalThis.forceModel;\n"
      "const TUBE_CONDITIONS = " +
      std::to_string(inputs.conditions.size()) + ";\n" + numbersText(model, inputs, "const ") +
      inJavaScript(base::replaced(linesOf(kTubeStartInJs, filling), {{"@INPUTS@", filling.places}})) +
      inJavaScript(linesOf(kTubeBody, filling)) +
      "\nif (typeof module === 'object' && module.exports) {\n"
      "  module.exports = { tubeStart, tubePlace, tubeChange, tubeStep };\n} else {\n"
      "  Object.assign(globalThis, { tubeStart, tubePlace, tubeChange, tubeStep });\n}\n})();\n");
}

}  // namespace tactus::exchange
