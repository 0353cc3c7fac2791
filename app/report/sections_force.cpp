#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "app/figures/force_curves.h"
#include "app/report/palette.h"
#include "app/report/report_sections.h"
#include "app/report/surface_plot.h"
#include "core/analysis/rule_table.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"
#include "core/procedure/procedure.h"
#include "elicitation/force/force_frequency.h"

namespace tactus::report {

namespace {

constexpr std::array<Dash, 4> kDashes = {Dash::kSolid, Dash::kDashed, Dash::kDashDot, Dash::kDotted};

/// One of the families of curves: the averaged force at several values of one input.
struct Family {
  std::string heading;
  std::string setting;
  std::vector<std::pair<std::string, std::vector<double>>> curves = {};
};

/// `Fig. 10a, Fig. 10b`: the published figures in which one input varies.
std::string publishedNames(const ReportContext& context) {
  std::vector<std::string> names;
  for (const procedure::Figure& figure : context.about().figures) {
    if (!figure.varied.empty()) names.push_back(procedure::textIn(figure.name, "en"));
  }
  return base::joined(names, ", ");
}

std::size_t indexOf(const fuzzy::ForceModel& model, const std::string& id) {
  return static_cast<std::size_t>(
      std::find_if(model.inputs.begin(), model.inputs.end(), [&id](const auto& input) { return input.id == id; }) -
      model.inputs.begin());
}

/// What the figure sets, the others at their usual values.
std::vector<double> pointOf(const ReportContext& context, const procedure::Figure& figure) {
  std::vector<double> point = context.usual;
  for (const auto& [id, value] : figure.at) point[indexOf(context.in.built.model, id)] = value;
  return point;
}

/// The published figures in which one input varies.
std::vector<Family> publishedFamilies(const ReportContext& context) {
  const fuzzy::ForceModel& model = context.in.built.model;
  std::vector<Family> out;
  char letter = 'a';
  for (const procedure::Figure& figure : context.about().figures) {
    if (figure.varied.empty()) continue;
    const std::size_t varied = indexOf(model, figure.varied);
    const fuzzy::Variable& input = model.inputs[varied];
    std::vector<double> point = pointOf(context, figure);
    Family& family =
        out.emplace_back(std::string("(") + letter++ + ") " + input.label, settingText(context, point, {varied}));
    for (const double value : figure.values) {
      point[varied] = value;
      family.curves.emplace_back(base::formatNumber(value) + (input.unit == "1" ? "" : " " + input.unit), point);
    }
  }
  return out;
}

/// Where nothing is published: each input but the way in the middle of each of its words, the others at their usual
/// values.
std::vector<Family> ownFamilies(const ReportContext& context) {
  const fuzzy::ForceModel& model = context.in.built.model;
  std::vector<Family> out;
  char letter = 'a';
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const fuzzy::Variable& input = model.inputs[i];
    if (fuzzy::roleOf(input) == fuzzy::Role::kWay) continue;
    Family family{std::string("(") + letter++ + ") " + input.label, settingText(context, context.usual, {i}), {}};
    for (const fuzzy::Term& term : input.terms) {
      std::vector<double> point = context.usual;
      point[i] = analysis::peakPosition(term, input.min, input.max);
      family.curves.emplace_back(term.label, std::move(point));
    }
    out.push_back(std::move(family));
  }
  return out;
}

/// `lubrication, neck flexion and speed`.
std::string listedInputs(const ReportContext& context) {
  std::vector<std::string> names;
  for (const fuzzy::Variable& input : context.in.built.model.inputs) {
    if (fuzzy::roleOf(input) != fuzzy::Role::kWay) names.push_back(base::lowered(input.label));
  }
  if (names.size() < 2) return base::joined(names, "");
  const std::string last = names.back();
  names.pop_back();
  return base::joined(names, ", ") + " and " + last;
}

std::string familyPlot(const ReportContext& context, const Family& family) {
  SvgPlot plot({.title = family.heading + ": force over depth",
                .description = family.setting.empty() ? "Averaged model." : "Averaged model at " + family.setting + ".",
                .width = 940,
                .height = 300,
                .x = depthAxis(context),
                .y = forceAxis(context),
                .simulated = context.simulated()});
  markRegions(plot, context.regions);
  for (std::size_t i = 0; i < family.curves.size(); ++i) {
    // Gray, as in the workbench: what tells the curves apart is no force.
    const double share =
        static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, family.curves.size() - 1));
    const std::string color = figures::hex(figures::mixed({0x57, 0x60, 0x6A}, {0x1B, 0x1F, 0x24}, share));
    plot.line(toSeries(context.curves->plotted(family.curves[i].second, std::nullopt)),
              {.color = color, .width = 1.6 + share, .dash = kDashes[i % kDashes.size()]}, family.curves[i].first);
  }
  return plot.svg();
}

/// Stretches of depth without a force.
std::vector<figures::Interval> holesOf(const ForceCurve& curve) {
  std::vector<double> depths_mm;
  std::vector<fuzzy::Evaluation> forces;
  for (const CurvePoint& point : curve) {
    depths_mm.push_back(point.depth_mm);
    forces.push_back({point.force_n.value_or(0), point.force_n.has_value()});
  }
  return figures::silentIntervals(depths_mm, forces);
}

/// The range of many experts' forces and the middle 80 % of them.
void drawRange(SvgPlot& plot, const ReportContext& context, std::size_t experts) {
  Series lowest, low, high, highest;
  std::vector<std::vector<double>> forces_n;
  for (std::size_t e = 0; e < experts; ++e) {
    const ForceCurve curve = context.curves->curve(context.usual, e);
    forces_n.resize(curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
      if (e == 0) {
        for (Series* series : {&lowest, &low, &high, &highest}) series->push_back({curve[i].depth_mm, std::nullopt});
      }
      if (curve[i].force_n) forces_n[i].push_back(*curve[i].force_n);
    }
  }
  for (std::size_t i = 0; i < forces_n.size(); ++i) {
    if (forces_n[i].empty()) continue;
    lowest[i].y = base::quantile(forces_n[i], 0);
    low[i].y = base::quantile(forces_n[i], 0.1);
    high[i].y = base::quantile(forces_n[i], 0.9);
    highest[i].y = base::quantile(forces_n[i], 1);
  }
  plot.between(lowest, highest, kSky, 0.2, "All " + std::to_string(experts) + " experts");
  plot.between(low, high, kBlue, 0.25, "Middle 80 % of them");
}

std::string lineName(const ReportContext& context, const fuzzy::Expert& expert) {
  if (context.demo == nullptr) return expert.label;
  return expert.id + (expert.id == context.demo->published_expert ? " (published rules)" : " (simulated)");
}

std::string inMillimeters(double depth_mm) { return base::formatFixed(depth_mm, 0); }

}  // namespace

PlotAxis depthAxis(const ReportContext& context) {
  return {.label = depthVariable(context.in.built.model).label + " (mm)",
          .min = context.curves->depthMin(),
          .max = context.curves->depthMax()};
}

PlotAxis forceAxis(const ReportContext& context) {
  const fuzzy::Variable& force = context.in.built.model.output;
  return {.label = force.label + " (N)", .min = force.min, .max = force.max};
}

std::string regionCodes(const std::vector<Region>& regions) {
  std::vector<std::string> parts;
  for (const Region& region : regions) parts.push_back(region.code + " " + base::lowered(region.label));
  return base::joined(parts, ", ");
}

void markRegions(SvgPlot& plot, const std::vector<Region>& regions) {
  for (std::size_t i = 0; i < regions.size(); ++i) {
    plot.band(regions[i].from_mm, regions[i].to_mm, "#EEF2F6", i % 2 == 0 ? 1 : 0, regions[i].label, regions[i].code);
  }
}

LineLook expertLook(std::size_t index) {
  return {.color = seriesColor(index), .width = 2.2, .dash = kDashes[index % kDashes.size()]};
}

void addSurface(HtmlPage& page, const ReportContext& context) {
  const auto& inputs = context.in.built.model.inputs;
  const auto rate = fuzzy::rateOf(inputs);
  if (!rate) return;
  page.section("Force over depth and speed");
  constexpr double kDepthSteps = 120;
  constexpr int kSpeedSteps = 32;
  const fuzzy::Variable* const speed = &inputs[*rate];
  const auto& figures = context.about().figures;
  const auto published = std::find_if(figures.begin(), figures.end(), [](const auto& one) { return !one.map.empty(); });
  std::vector<double> at = published == figures.end() ? context.usual : pointOf(context, *published);
  const std::string others = settingText(context, at, {*rate});
  SurfaceGrid grid;
  const double step_mm = (context.curves->depthMax() - context.curves->depthMin()) / kDepthSteps;
  for (int i = 0; i <= static_cast<int>(kDepthSteps); ++i) grid.x.push_back(context.curves->depthMin() + i * step_mm);
  for (int j = 0; j <= kSpeedSteps; ++j) grid.y.push_back(speed->min + (speed->max - speed->min) * j / kSpeedSteps);
  for (const double depth_mm : grid.x) {
    for (const double speed_mm_s : grid.y) {
      at[*rate] = speed_mm_s;
      grid.z.push_back(context.curves->force(at, depth_mm, std::nullopt));
    }
  }
  page.figure({.caption = strong(context.demo != nullptr ? "Fig. 9, recomputed." : "Force over depth and speed.") +
                          " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                          " Averaged force over depth and speed" + (others.empty() ? std::string() : " at " + others) +
                          "." +
                          (context.demo != nullptr ? " Three of the four experts are simulated. The numbers behind the "
                                                     "paper's figure are not published."
                                                   : ""),
               .panels = {{.svg = surfacePlot({.title = "Averaged force over depth and speed",
                                               .description = others,
                                               .width = 940,
                                               .height = 560,
                                               .x = depthAxis(context),
                                               .y = {.label = "Speed (mm/s)", .min = speed->min, .max = speed->max},
                                               .z = {.label = "Force (N)",
                                                     .min = context.in.built.model.output.min,
                                                     .max = context.in.built.model.output.max},
                                               .simulated = context.simulated()},
                                              grid)}}});
}

void addInfluences(HtmlPage& page, const ReportContext& context) {
  auto families = publishedFamilies(context);
  const bool published = !families.empty();
  if (!published) families = ownFamilies(context);
  if (families.empty()) return;
  page.section("Influence of " + listedInputs(context));
  page.paragraph("Averaged force over depth, one input varied at a time. Regions: " + regionCodes(context.regions) +
                 ".");
  Figure figure{
      .caption = context.demo != nullptr
                     ? strong("Fig. 10, recomputed.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                           " The settings are the paper's; which values of the varied input its curves show "
                           "is not said in the text, nor are their numbers published. Three of the four "
                           "experts are simulated to follow the text."
                     : strong("One input varied at a time.") + " " +
                           marks(context, {Badge::kComputed, Badge::kSimulated}) +
                           (published ? " At the settings of published figures: " + publishedNames(context) + "."
                                      : " In the middle of each of its words, the others at their usual values."),
      .panels = {}};
  for (const Family& family : families) {
    figure.panels.push_back(
        {.heading = family.heading + Markup::raw(" ") + muted(family.setting), .svg = familyPlot(context, family)});
  }
  page.figure(figure);
}

SvgPlot depthPlot(const ReportContext& context, const std::string& title, double height, const PlotAxis& y) {
  SvgPlot plot({.title = title,
                .description = settingText(context, context.usual),
                .width = 940,
                .height = height,
                .x = depthAxis(context),
                .y = y,
                .simulated = context.simulated()});
  markRegions(plot, context.regions);
  return plot;
}

void addExperts(HtmlPage& page, const ReportContext& context) {
  page.section(context.demo != nullptr ? "Four experts and their mean" : "The experts and their mean");
  SvgPlot plot =
      depthPlot(context, "Force over depth of each expert and of the averaged model", 380, forceAxis(context));
  const auto& experts = context.in.built.model.experts;
  if (experts.size() > kMostDrawn) {
    drawRange(plot, context, experts.size());
  } else {
    for (std::size_t i = 0; i < experts.size(); ++i) {
      plot.line(toSeries(context.curves->plotted(context.usual, i)), expertLook(i), lineName(context, experts[i]));
    }
  }
  plot.line(toSeries(context.curves->plotted(context.usual, std::nullopt)), {.color = kInk, .width = 3.2}, "Mean");
  page.figure({.caption = strong(context.demo != nullptr ? "Fig. 11, recomputed." : "Each expert and the mean.") + " " +
                          marks(context, {Badge::kComputed, Badge::kSimulated}) +
                          " Force over depth of each expert and of the averaged model" + atUsual(context) + "." +
                          (context.demo != nullptr
                               ? " Only the rules of " + context.demo->published_expert +
                                     " are published; the other experts are simulated. The numbers behind the paper's "
                                     "figure are not published."
                               : ""),
               .panels = {{.svg = plot.svg()}}});
}

void addReadings(HtmlPage& page, const ReportContext& context) {
  page.section("The published rules in three readings");
  page.paragraph(
      "The questionnaire (Table A1) asks about nasal cavity, nasopharynx, oropharynx, laryngopharynx and esophagus. "
      "The "
      "printed rules (Table A2) name no oropharynx, but a stomach. The table can be read in three ways, none is "
      "proved. "
      "Where no rule fires the model has a hole and gives no force.");
  Figure figure{
      .caption = strong("Table A2 at the setting of Fig. 11.") + " " +
                 marks(context, {Badge::kPublished, Badge::kComputed, Badge::kSimulated}) + " Rules of " +
                 context.demo->published_expert +
                 " alone at 50 mm/s, lubrication 1, neck flexion 60 deg. The rules are published, the terms of "
                 "the speed come from simulated strokes. Dark gray: no rule fires.",
      .panels = {}};
  const auto& experts = context.in.built.model.experts;
  const auto published = static_cast<std::size_t>(
      std::find_if(experts.begin(), experts.end(),
                   [&](const fuzzy::Expert& expert) { return expert.id == context.demo->published_expert; }) -
      experts.begin());
  for (const S4Reading& reading : context.demo->readings) {
    const auto curves = ForceCurves::of(reading.model);
    if (!curves || reading.model.experts.empty()) continue;
    const ForceCurve curve = curves->plotted(pointAt(reading.model, kFig11), 0);
    SvgPlot plot({.title = reading.title + ": force over depth",
                  .description = reading.assumes,
                  .width = 940,
                  .height = 250,
                  .x = depthAxis(context),
                  .y = forceAxis(context),
                  .simulated = context.simulated()});
    markRegions(plot, context.regions);
    std::vector<std::string> texts;
    for (const auto& [from_mm, to_mm] : holesOf(curve)) {
      plot.band(from_mm, to_mm, kMuted, 0.35, {});
      plot.label((from_mm + to_mm) / 2, context.in.built.model.output.max * 0.5, "hole", kInk);
      texts.push_back(inMillimeters(from_mm) + " to " + inMillimeters(to_mm) + " mm");
    }
    plot.line(toSeries(curve), {.color = seriesColor(published), .width = 2.4});
    figure.panels.push_back(
        {.heading =
             reading.title + Markup::raw(" ") +
             muted(reading.assumes + (texts.empty() ? std::string(" No hole at this setting.")
                                                    : " No rule fires at " + base::joined(texts, " and ") + ".")),
         .svg = plot.svg()});
  }
  page.figure(figure);
}

void addPublishedForces(HtmlPage& page, const ReportContext& context) {
  const auto& published = context.about().published;
  if (published.empty() || context.curves == nullptr) return;
  const std::size_t way = fuzzy::wayOf(context.in.built.model.inputs).value();
  Table table{.caption = strong("Published forces, for comparison.") + " " + badge(Badge::kPublished) +
                         " What others measured of something like it, and the range of the averaged force over the "
                         "same stretch" +
                         atUsual(context) + ". No model was fitted to them.",
              .head = {{{.text = "What"},
                        numberCell("Published, N", true),
                        numberCell("Averaged force, N"),
                        {.text = "What it is not"},
                        {.text = "Source"}}},
              .body = {},
              .wide = true};
  for (const auto& force : published) {
    constexpr int kPlaces = 200;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    std::vector<double> point = context.usual;
    for (int i = 0; i <= kPlaces; ++i) {
      point[way] = force.from_mm + (force.to_mm - force.from_mm) * i / kPlaces;
      const auto answer = context.curves->compiled().evaluate(point);
      if (!answer.fired) continue;
      least = std::min(least, answer.force_n);
      most = std::max(most, answer.force_n);
    }
    const auto range = [](double low_n, double high_n) {
      const std::string low = base::formatFixed(low_n, 2);
      const std::string high = base::formatFixed(high_n, 2);
      return low == high ? low : low + " to " + high;
    };
    table.body.push_back({headingCell(procedure::textIn(force.label, "en")),
                          numberCell(range(force.low_n, force.high_n), true),
                          numberCell(most < least ? "–" : range(least, most)),
                          {.text = procedure::textIn(force.is_not, "en")},
                          {.text = force.source}});
  }
  page.subsection("Published forces");
  page.table(table);
}

// The frequency curve beside the paper's vote.

namespace {

/// A trapezoid or triangle without its vertical edges, which only end the universe.
Series shapeOf(const fuzzy::Term& term) {
  const auto m = fuzzy::MembershipFunction::of(term);
  Series points;
  if (m.a < m.b) points.push_back({m.a, 0.0});
  points.push_back({m.b, 1.0});
  points.push_back({m.c, 1.0});
  if (m.c < m.d) points.push_back({m.d, 0.0});
  return points;
}

constexpr double kDotStepN = 0.016;

/// The shares as dots and `terms` as lines, a color for each term of the model's output.
std::string curvePlot(const ReportContext& context, const elicitation::FrequencyTerms& frequency,
                      const std::vector<fuzzy::Term>& terms, const std::string& title) {
  const fuzzy::Variable force = context.in.built.about().output;  // the shares are of all its terms
  const double end_n = context.in.built.model.output.max;
  SvgPlot plot({.title = title,
                .description = "Dots: share of the answers for each term. Lines: the term's membership function.",
                .width = 460,
                .height = 280,
                .x = {.label = "Insertion force (N)", .min = 0, .max = end_n + 0.05},
                .y = {.label = "Share, membership", .min = 0, .max = 1.05, .ticks = {0, 0.25, 0.5, 0.75, 1}},
                .simulated = context.simulated()});
  for (std::size_t k = 0; k < force.terms.size(); ++k) {
    const std::string color = figures::hex(figures::termColor(force, force.terms, k));
    if (const auto* term = fuzzy::findTerm(terms, force.terms[k].id)) {
      plot.line(shapeOf(*term), {.color = color, .width = 2}, force.terms[k].label);
    }
    // Equal shares of one force would hide each other.
    const double aside_n = kDotStepN * (static_cast<double>(k) - 0.5 * static_cast<double>(force.terms.size() - 1));
    Series dots;
    for (const auto& step : frequency.steps) {
      if (step.votes > 0 && step.shares[k] > 0) dots.push_back({step.force_n + aside_n, step.shares[k]});
    }
    plot.scatter(dots, color, 3);
  }
  return plot.svg();
}

std::string_view modelTermsFrom(const ReportContext& context) {
  switch (context.in.build_settings.force_terms) {
    case elicitation::ForceTermsFrom::kFrequency: return "frequency curve";
    case elicitation::ForceTermsFrom::kThresholds: return "participants’ thresholds";
    case elicitation::ForceTermsFrom::kProbit: return "ordered probit";
    case elicitation::ForceTermsFrom::kVote: break;
  }
  return "vote";
}

}  // namespace

void addFrequency(HtmlPage& page, const ReportContext& context) {
  if (!context.in.built.force_terms) return;
  const auto frequency = elicitation::frequencyTerms(context.in.built.about().output, context.in.built.votes);
  if (!frequency) return;
  page.subsection("Every answer counts: the frequency curve");
  page.paragraph(
      "The vote keeps the winner of each force and forgets the rest. The frequency curve keeps all answers: of all "
      "trapezoids that sum to 1, those closest to the shares of the answers (least squares). It is shown for "
      "comparison; the model uses the " +
      std::string(modelTermsFrom(context)) + ".");
  page.figure({.caption = strong("Shares of the answers and the terms from them.") + " " +
                          marks(context, {Badge::kComputed, Badge::kSimulated}) +
                          " The answers as shares (dots, those of one force side by side) and membership functions "
                          "(lines). Root mean square of membership "
                          "minus share for the frequency curve: " +
                          base::formatFixed(frequency->rms_error, 3) + ".",
               .panels = {{.heading = "(a) Frequency curve, least squares",
                           .svg = curvePlot(context, *frequency, frequency->output.terms, "Frequency curve")},
                          {.heading = context.in.build_settings.force_terms == elicitation::ForceTermsFrom::kVote
                                          ? Markup("(b) The paper’s vote")
                                          : Markup("(b) The model: ") + Markup(modelTermsFrom(context)),
                           .svg = curvePlot(context, *frequency, context.in.built.model.output.terms, "Vote")}},
               .columns = 2});
}

}  // namespace tactus::report
