#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/palette.h"
#include "app/report/report_sections.h"
#include "core/analysis/force_difference.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::report {

namespace {

/// Points at which a membership function is drawn: its corners, or enough for a smooth bell.
Series shapeOf(const fuzzy::Term& term, const fuzzy::Variable& variable) {
  const fuzzy::MembershipFunction membership = fuzzy::MembershipFunction::of(term);
  std::vector<double> xs;
  if (membership.gaussian) {
    constexpr int kPoints = 120;
    for (int i = 0; i <= kPoints; ++i) xs.push_back(variable.min + (variable.max - variable.min) * i / kPoints);
  } else {
    Series corners;
    // Both ends of a vertical edge are drawn.
    if (membership.a > variable.min) corners.push_back({variable.min, 0.0});
    corners.push_back({membership.a, 0.0});
    corners.push_back({membership.b, 1.0});
    corners.push_back({membership.c, 1.0});
    corners.push_back({membership.d, 0.0});
    return corners;
  }
  Series out;
  for (const double x : xs) out.push_back({x, membership(x)});
  return out;
}

/// Angles read best in steps of a right angle's parts; empty leaves the choice to the plot.
std::vector<double> ticksFor(const fuzzy::Variable& variable) {
  constexpr double kStepDeg = 15;
  constexpr double kMostSteps = 8;
  std::vector<double> ticks;
  if (variable.unit != "deg" || (variable.max - variable.min) / kStepDeg > kMostSteps) return ticks;
  for (double tick = std::ceil(variable.min / kStepDeg) * kStepDeg; tick <= variable.max; tick += kStepDeg) {
    ticks.push_back(tick);
  }
  return ticks;
}

std::string unitText(const fuzzy::Variable& variable) {
  if (variable.unit != "1" && !variable.unit.empty()) return variable.label + " (" + variable.unit + ")";
  return variable.label + " (" + base::formatNumber(variable.min) + " to " + base::formatNumber(variable.max) +
         ", no unit)";
}

/// Shorter text for a label that would run into its neighbors.
std::string regionCode(const std::vector<Region>& regions, const std::string& id) {
  const auto found =
      std::find_if(regions.begin(), regions.end(), [&](const Region& region) { return region.id == id; });
  return found == regions.end() ? id : found->code;
}

/// Whether the terms of a variable come from data of simulated participants; the others are defaults.
bool fromSimulated(const ReportContext& context, const fuzzy::Variable& variable) {
  const bool speeds = fuzzy::roleOf(variable) == fuzzy::Role::kRate && !context.in.built.speeds.empty();
  const bool votes = variable.id == context.in.built.model.output.id && context.in.built.force_terms.has_value();
  return context.simulated() && (speeds || votes);
}

std::string termPlot(const ReportContext& context, const fuzzy::Variable& variable,
                     const std::vector<fuzzy::Term>& terms) {
  PlotFrame frame;
  frame.title = "Membership functions of " + base::lowered(variable.label);
  frame.description = "One shape per term.";
  frame.width = 460;
  frame.height = 220;
  frame.x = {.label = unitText(variable), .min = variable.min, .max = variable.max, .ticks = ticksFor(variable)};
  frame.y = {.label = "Membership", .min = 0, .max = 1.18, .ticks = {0, 0.5, 1}};
  frame.simulated = fromSimulated(context, variable);
  SvgPlot plot(std::move(frame));
  for (std::size_t i = 0; i < terms.size(); ++i) {
    Series shape = shapeOf(terms[i], variable);
    const std::string color = figures::hex(figures::termColor(variable, terms, i));
    plot.area(shape, color, 0.1);
    plot.line(shape, {.color = color, .width = 2});
  }
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const fuzzy::MembershipFunction m = fuzzy::MembershipFunction::of(terms[i]);
    const double middle = m.gaussian ? m.mean : (std::max(m.b, variable.min) + std::min(m.c, variable.max)) / 2;
    const bool way = variable.id == depthVariable(context.in.built.model).id;
    const std::string text = way ? regionCode(context.regions, terms[i].id) : terms[i].label;
    plot.label(middle, 1.07, text, readableText(figures::termColor(variable, terms, i)));
  }
  return plot.svg();
}

/// Lists of depth terms that experts have for themselves, with who has them.
std::vector<std::pair<std::string, std::vector<fuzzy::Term>>> ownLists(const ReportContext& context,
                                                                       const std::string& variable) {
  std::vector<std::pair<std::string, std::vector<fuzzy::Term>>> lists;
  for (const fuzzy::Expert& expert : context.in.built.model.experts) {
    for (const fuzzy::TermOverride& own : expert.overrides) {
      if (own.variable != variable) continue;
      const auto found =
          std::find_if(lists.begin(), lists.end(), [&](const auto& list) { return list.second == own.terms; });
      if (found == lists.end()) {
        lists.emplace_back(expert.id, own.terms);
      } else {
        found->first += ", " + expert.id;
      }
    }
  }
  return lists;
}

/// Where the terms of a study come from, one sentence.
std::string originOfTerms(const ReportContext& context) {
  const auto& inputs = context.in.built.model.inputs;
  std::string text = "Terms of the " +
                     (inputs.size() == 1 ? std::string("input") : std::to_string(inputs.size()) + " inputs") +
                     " and of the force. Those of the way and of the conditions are the procedure’s";
  if (fuzzy::rateOf(inputs)) {
    text += context.in.built.speeds.empty() ? "; the speed has its default terms too"
                                            : "; the speed comes from the participants’ strokes";
  }
  text += context.in.built.force_terms ? ", the force from their judgements" : ", the force has its default terms";
  return text + ".";
}

}  // namespace

void addMembershipFunctions(HtmlPage& page, const ReportContext& context) {
  page.section("Membership functions");
  Figure figure{
      .caption =
          (context.demo != nullptr
               ? strong("Fig. 3, recomputed.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                     " Terms of the four inputs and of the force. Lubrication, neck flexion and depth are defaults of "
                     "this project, because the paper’s vertices are not printed; the speed comes from the simulated "
                     "strokes, the force from the published votes."
               : strong("Membership functions.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) + " " +
                     originOfTerms(context)) +
          " " + regionCodes(context.regions) + ".",
      .panels = {},
      .columns = 2};
  char letter = 'a';
  std::vector<const fuzzy::Variable*> variables;
  for (const fuzzy::Variable& input : context.in.built.model.inputs) variables.push_back(&input);
  variables.push_back(&context.in.built.model.output);
  for (const fuzzy::Variable* variable : variables) {
    figure.panels.push_back({.heading = std::string("(") + letter++ + ") " + variable->label,
                             .svg = termPlot(context, *variable, variable->terms)});
  }
  for (const fuzzy::Variable* variable : variables) {
    const auto lists = ownLists(context, variable->id);
    if (lists.size() > kMostDrawn) continue;
    for (const auto& [who, terms] : lists) {
      figure.panels.push_back({.heading = variable->label + Markup::raw(" ") + muted("as " + who + " was asked"),
                               .svg = termPlot(context, *variable, terms)});
    }
  }
  page.figure(figure);
}

void addVertices(HtmlPage& page, const ReportContext& context) {
  const auto& model = context.in.built.model;
  Table table{.caption = strong("Vertices of the membership functions.") + " " + marks(context, {Badge::kComputed}) +
                         " Trapezoids a, b, c, d: 0 outside a to d, 1 from b to c. Triangles have three vertices.",
              .head = {{{.text = "Variable"}, {.text = "Term"}, {.text = "Vertices"}, {.text = "Unit"}}},
              .body = {}};
  const auto add = [&](const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, const Markup& name) {
    for (std::size_t i = 0; i < terms.size(); ++i) {
      std::vector<std::string> points;
      for (const double point : terms[i].points) points.push_back(base::formatNumber(std::round(point * 1e4) / 1e4));
      table.body.push_back({headingCell(i == 0 ? name : Markup()),
                            {.text = terms[i].label},
                            {.text = base::joined(points, ", ")},
                            {.text = variable.unit == "1" ? std::string("none") : variable.unit}});
    }
  };
  std::vector<const fuzzy::Variable*> variables;
  for (const fuzzy::Variable& input : model.inputs) variables.push_back(&input);
  variables.push_back(&model.output);
  for (const fuzzy::Variable* variable : variables) {
    add(*variable, variable->terms, variable->label);
    const auto lists = ownLists(context, variable->id);
    for (const auto& [who, terms] : lists) {
      if (lists.size() <= kMostDrawn) add(*variable, terms, Markup(variable->label) + " " + muted("of " + who));
    }
  }
  page.table(table);
}

void addReachableRange(HtmlPage& page, const ReportContext& context) {
  page.section("Reachable range");
  const fuzzy::Variable& force = context.in.built.model.output;
  const auto range = analysis::reachableRange(context.in.built.model, context.curves->compiled());
  if (range.fired == 0) {
    page.paragraph("No rule fires anywhere on the grid that was tried.");
    return;
  }
  page.paragraph("The universe of the force runs from " + base::formatNumber(force.min) + " to " +
                 base::formatNumber(force.max) + " N. On a grid over all inputs the averaged model gives " +
                 strong(base::formatFixed(range.min_n, 3) + " to " + base::formatFixed(range.max_n, 3) + " N") +
                 ". The centroid of a set lies inside the set, so it never reaches the ends of the universe: the " +
                 base::formatNumber(force.max) +
                 " N at its upper end cannot come out. Widening the outer terms past the universe "
                 "would change that and the model with it, so it is left to the researcher.");
}

}  // namespace tactus::report
