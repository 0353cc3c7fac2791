// What each expert does to the mean, in newtons.
#include <algorithm>
#include <string>

#include "app/report/palette.h"
#include "app/report/report_sections.h"
#include "core/analysis/force_difference.h"
#include "core/base/text.h"
#include "elicitation/agreement/expert_influence.h"
#include "elicitation/force/noticeable_force.h"
#include "elicitation/uncertainty/force_bands.h"
#include "elicitation/uncertainty/own_words.h"

namespace tactus::report {
namespace {

using elicitation::BandKind;
using elicitation::Drawn;
using elicitation::ForceBands;

constexpr std::size_t kCurveDepths = 121;
constexpr std::size_t kMostReplicates = 500;
constexpr std::size_t kReplicatesOfMany = 200;
constexpr std::size_t kMany = 40;  // participants

std::string_view whatOf(BandKind kind) {
  switch (kind) {
    case BandKind::kAgain: return "these participants once more";
    case BandKind::kOthers: return "as many other participants like these";
    case BandKind::kNext: return "one more participant";
    case BandKind::kWords: return "the words of each participant";
  }
  return "";
}

/// ` At the usual values (…).`; empty for a model of the way alone.
std::string settingOf(const ReportContext& context) {
  const std::string text = settingText(context, context.usual);
  return text.empty() ? text : " At the usual values (" + text + ").";
}

/// The points of the curve at the usual values, then the middle of each region.
std::vector<std::vector<double>> pointsOf(const ReportContext& context) {
  const fuzzy::ForceModel& model = context.in.built.model;
  const std::size_t depth = fuzzy::wayOf(model.inputs).value();
  auto points = analysis::linePoints(model, context.usual, depth, kCurveDepths);
  for (const auto& region : context.regions) {
    points.push_back(context.usual);
    points.back()[depth] = (region.from_mm + region.to_mm) / 2;
  }
  return points;
}

std::string bandPlot(const ReportContext& context, const elicitation::ForceBand& band,
                     const std::vector<std::vector<double>>& points, std::size_t depth) {
  Series low, high, mean;
  for (std::size_t p = 0; p < kCurveDepths; ++p) {
    const auto& one = band.points[p];
    const double depth_mm = points[p][depth];
    mean.push_back({depth_mm, one.force_n});
    low.push_back({depth_mm, one.force_n ? std::optional(one.low_n) : std::nullopt});
    high.push_back({depth_mm, one.force_n ? std::optional(one.high_n) : std::nullopt});
  }
  const bool words = band.kind == BandKind::kWords;
  SvgPlot plot = depthPlot(
      context, (words ? "Averaged force under " : "95 % band of the averaged force: ") + std::string(whatOf(band.kind)),
      250, forceAxis(context));
  plot.between(low, high, kSky, 0.45, words ? "lowest to highest" : "95 % at each depth");
  plot.line(mean, {.color = kInk, .width = 2.4}, "Averaged force");
  return plot.svg();
}

/// `± .21 (3.0)`: the half width, and in just-noticeable differences.
Cell halfCell(const elicitation::ForceBand& band, std::size_t point, bool group_start) {
  if (band.points.empty() || !band.points[point].force_n) return numberCell(muted("–"), group_start);
  const auto& one = band.points[point];
  return numberCell("± " + base::formatFixed(one.half_width_n, 3) + " (" +
                        base::formatFixed(one.half_width_n / elicitation::justNoticeableDifference(*one.force_n), 1) +
                        ")",
                    group_start);
}

Cell spreadCell(const std::vector<elicitation::DrawnForce>& drawn, std::size_t point, bool group_start = false) {
  return numberCell(drawn.empty() ? muted("–") : Markup(base::formatFixed(drawn[point].sd_n, 3)), group_start);
}

Table splitTable(const ReportContext& context, const ForceBands& bands) {
  const std::vector<std::vector<elicitation::DrawnForce>> parts = {
      bands.drawn(Drawn::kOwnStrokes), bands.drawn(Drawn::kOwnJudgements), bands.drawn(Drawn::kWhoMoved),
      bands.drawn(Drawn::kWhoJudged), bands.drawn(Drawn::kWhoAnswered)};
  const auto again = bands.band(BandKind::kAgain);
  const auto others = bands.band(BandKind::kOthers);
  const auto next = bands.band(BandKind::kNext);
  Table table{.caption = strong("What the bands are made of.") + " " +
                         marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " At the middle of each region. Half widths of the 95 % bands in N, in brackets in "
                         "just-noticeable differences; then the standard deviation of the force if only one thing is "
                         "drawn anew.",
              .head = {{{.text = ""},
                        {.text = "Band", .columns = 3, .group_start = true},
                        {.text = "Own, once more", .columns = 2, .group_start = true},
                        {.text = "Other participants", .columns = 3, .group_start = true}},
                       {{.text = "Region"},
                        numberCell("again", true),
                        numberCell("others"),
                        numberCell("next"),
                        numberCell("strokes", true),
                        numberCell("judgements"),
                        numberCell("speeds", true),
                        numberCell("votes"),
                        numberCell("rules")}},
              .body = {},
              .note = "The parts do not add up to the whole. Bands are for one depth at a time, not for the curve.",
              .wide = true};
  for (std::size_t r = 0; r < context.regions.size(); ++r) {
    const std::size_t p = kCurveDepths + r;
    table.body.push_back({headingCell(context.regions[r].label), halfCell(again, p, true), halfCell(others, p, false),
                          halfCell(next, p, false), spreadCell(parts[0], p, true), spreadCell(parts[1], p),
                          spreadCell(parts[2], p, true), spreadCell(parts[3], p), spreadCell(parts[4], p)});
  }
  return table;
}

void addWordsAndRules(HtmlPage& page, const ReportContext& context) {
  const auto found = elicitation::wordsAndRules(context.in.study, context.in.built, context.in.build_settings);
  if (!found || found->points == 0) return;
  page.paragraph(strong("Whose words, whose rules.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                 " " + Markup(elicitation::wordsAndRulesSentence(*found)) + " Over the whole input space.");
}

}  // namespace

void addUncertainty(HtmlPage& page, const ReportContext& context) {
  if (context.in.replicates == 0) return;
  const std::size_t people = context.in.study.participants.size();
  const auto points = pointsOf(context);
  const bool many = people > kMany;
  auto bands =
      ForceBands::of(context.in.study, context.in.built, context.in.build_settings,
                     {.points = points,
                      .replicates = std::min(context.in.replicates, many ? kReplicatesOfMany : kMostReplicates),
                      .words = !many});
  if (!bands || bands->planned() == 0) return;
  while (bands->add(bands->planned())) {
  }
  const std::size_t depth = fuzzy::wayOf(context.in.built.model.inputs).value();

  page.section("How far the averaged force can be trusted");
  page.paragraph(
      "Four questions with four answers. “Again”: what would these participants give once more? “Others”: what would "
      "as many other participants give? “Next”: where would the force of one more participant lie? “Words”: what would "
      "the same rules give if the words of the force were those of one participant? A few participants "
      "say little about others, and the band “others” says how little.");
  Figure figure{.caption = strong("Bands around the averaged force.") + " " +
                           marks(context, {Badge::kComputed, Badge::kSimulated}) + settingOf(context) + " " +
                           (people <= elicitation::kMostEnumerated && people > 1
                                ? "“Others” is enumerated over every draw of participants, each as a whole."
                                : "“Others” draws participants, each as a whole, at random.") +
                           " Cut at the forces that the model can give.",
                .panels = {}};
  std::vector<Markup> remarks;
  for (const auto kind : {BandKind::kAgain, BandKind::kOthers, BandKind::kNext, BandKind::kWords}) {
    if (kind == BandKind::kWords && many) continue;
    const auto band = bands->band(kind);
    const std::string label = "“" + std::string(name(kind)) + "”";
    if (band.points.empty()) {
      remarks.emplace_back(label + " has no band: the study has nothing to draw from.");
      continue;
    }
    figure.panels.push_back(
        {.heading = Markup(label) + " " + muted(whatOf(kind)), .svg = bandPlot(context, band, points, depth)});
    for (const auto& one : band.assumed)
      remarks.push_back(Markup(label) + ", " + strong("assumed") + ". " + Markup(one));
    for (const auto& one : band.not_included) {
      remarks.push_back(Markup(label) + ", " + strong("not included") + ". " + Markup(one));
    }
    std::size_t edges = 0;
    double abstains = 0;
    for (std::size_t p = 0; p < kCurveDepths; ++p) {
      edges += band.points[p].on_edge ? 1 : 0;
      abstains = std::max(abstains, band.points[p].abstains);
    }
    if (edges > 0) {
      remarks.emplace_back(label + ": at " + std::to_string(edges) + " of " + std::to_string(kCurveDepths) +
                           " depths the mean of the draws is more than a quarter of their standard deviation away from "
                           "the averaged force. The estimate sits on an edge there, usually of the vote.");
    }
    if (abstains > 0 && kind != BandKind::kWords) {
      remarks.emplace_back(label + ": up to " + base::formatFixed(100 * abstains, 1) +
                           " % of the draws give no force at some depth; no hole was filled.");
    }
  }
  if (!figure.panels.empty()) page.figure(figure);
  page.table(splitTable(context, *bands));
  if (!many) addWordsAndRules(page, context);
  if (!remarks.empty()) page.list(remarks);
}

namespace {

/// The averaged force at one depth without the expert `left_out`; nothing where the others have none.
std::optional<double> withoutExpert(const ReportContext& context, double depth_mm, std::size_t left_out) {
  const std::vector<double> weight = normalizedWeights(context.in.built.model);
  double sum = 0;
  double weights = 0;
  for (std::size_t e = 0; e < weight.size(); ++e) {
    const auto force_n = e == left_out ? std::nullopt : context.curves->force(context.usual, depth_mm, e);
    if (!force_n) continue;
    sum += weight[e] * *force_n;
    weights += weight[e];
  }
  if (!(weights > 0)) return std::nullopt;
  return sum / weights;
}

/// The experts who move the mean most, in the model's order: all of them, or kMostDrawn.
std::vector<std::size_t> mostInfluential(const ReportContext& context) {
  const auto& experts = context.in.built.influences.experts;
  std::vector<std::size_t> order(experts.size());
  for (std::size_t e = 0; e < order.size(); ++e) order[e] = e;
  const auto moves = [&](std::size_t e) { return experts[e].largest ? experts[e].largest->newtons : 0; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return moves(a) > moves(b); });
  order.resize(std::min(order.size(), kMostDrawn));
  std::sort(order.begin(), order.end());
  return order;
}

std::string influencePlot(const ReportContext& context) {
  const auto& experts = context.in.built.model.experts;
  const ForceCurve mean = context.curves->plotted(context.usual, std::nullopt);
  Series upper;
  Series lower;
  double largest_n = 0.1;
  for (const auto& point : mean) {
    std::optional<double> felt_n;
    if (point.force_n) felt_n = elicitation::justNoticeableDifference(*point.force_n);
    upper.push_back({point.depth_mm, felt_n});
    lower.push_back({point.depth_mm, felt_n ? std::optional<double>(-*felt_n) : std::nullopt});
    largest_n = std::max(largest_n, felt_n.value_or(0));
  }
  std::vector<Series> changes;
  const auto drawn = mostInfluential(context);
  for (const std::size_t e : drawn) {
    auto& change = changes.emplace_back();
    for (const auto& point : mean) {
      const auto without_n = withoutExpert(context, point.depth_mm, e);
      std::optional<double> change_n;
      if (point.force_n && without_n) change_n = *without_n - *point.force_n;
      largest_n = std::max(largest_n, std::abs(change_n.value_or(0)));
      change.push_back({point.depth_mm, change_n});
    }
  }
  SvgPlot plot = depthPlot(context, "Change of the mean when one expert is left out", 280,
                           {.label = "Change of the mean (N)", .min = -1.15 * largest_n, .max = 1.15 * largest_n});
  plot.area(upper, kSky, 0.2, "below one just-noticeable difference");
  plot.area(lower, kSky, 0.2);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    plot.line(changes[i], expertLook(drawn[i]), "without " + experts[drawn[i]].id);
  }
  return plot.svg();
}

std::string newtons(double value_n) { return base::formatFixed(value_n, 3); }

void addLeaveOneOut(HtmlPage& page, const ReportContext& context) {
  const auto& influences = context.in.built.influences;
  Table table{.caption = strong("The mean without each expert.") + " " +
                         marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " How far the averaged force moves when one expert is left out, over the whole input space.",
              .head = {{{.text = "Left out"},
                        numberCell("Root mean square (N)"),
                        numberCell("Largest (N)", true),
                        numberCell("in JNDs"),
                        {.text = "Where"},
                        numberCell("Alone on", true)}},
              .body = {},
              .note = "JND: just-noticeable difference. Largest: seen at " + std::to_string(influences.kink_points) +
                      " combinations of the terms’ vertices and the middles between them and at " +
                      std::to_string(influences.spread_points) +
                      " evenly spread points, so a lower bound. Alone on: share of the input space where no other "
                      "expert has a rule; without the expert the model would have no force there.",
              .wide = true};
  if (influences.experts.size() > kMostDrawn) {
    table.note += " The " + std::to_string(kMostDrawn) + " of " + std::to_string(influences.experts.size()) +
                  " experts who move the mean most.";
  }
  for (const std::size_t e : mostInfluential(context)) {
    const auto& expert = influences.experts[e];
    const auto& largest = expert.largest;
    table.body.push_back({headingCell(expert.expert),
                          numberCell(newtons(expert.rms_n)),
                          numberCell(largest ? newtons(largest->newtons) : "–", true),
                          numberCell(largest ? base::formatFixed(largest->noticeable, 1) : "–"),
                          {.text = largest ? settingText(context.in.built.model, largest->at) : std::string("–")},
                          numberCell(base::formatFixed(100 * expert.share_alone, 1) + " %", true)});
  }
  page.table(table);
}

void addDistances(HtmlPage& page, const ReportContext& context) {
  const auto& influences = context.in.built.influences;
  const auto& experts = influences.experts;
  if (experts.size() < 2 || experts.size() > kMostDrawn) return;
  Table table{
      .caption = strong("How far two experts are apart.") + " " +
                 marks(context, {Badge::kComputed, Badge::kSimulated}) +
                 " Root mean square over the input space, and in brackets the largest difference seen, in newtons.",
      .head = {{{.text = ""}}},
      .body = {}};
  for (std::size_t b = 1; b < experts.size(); ++b) table.head.front().push_back(numberCell(experts[b].expert));
  std::size_t pair = 0;
  for (std::size_t a = 0; a + 1 < experts.size(); ++a) {
    table.body.push_back({headingCell(experts[a].expert)});
    for (std::size_t b = 1; b < experts.size(); ++b) {
      if (b <= a) {
        table.body.back().push_back(numberCell(""));
        continue;
      }
      const auto& distance = influences.pairs[pair++];
      table.body.back().push_back(
          numberCell(distance.largest
                         ? Markup(newtons(distance.rms_n)) + " " + muted("(" + newtons(distance.largest->newtons) + ")")
                         : muted("never together")));
    }
  }
  page.table(table);
}

}  // namespace

void addInfluence(HtmlPage& page, const ReportContext& context) {
  page.subsection("What each expert does to the mean");
  if (context.in.built.model.experts.size() < 2) {
    page.paragraph("There is one expert only, whose force is the mean.");
    return;
  }
  addLeaveOneOut(page, context);
  page.figure({.caption = strong("The mean without each expert, over depth.") + " " +
                          marks(context, {Badge::kComputed, Badge::kSimulated}) + settingOf(context) +
                          " In the blue band a hand would not feel the change.",
               .panels = {{.svg = influencePlot(context)}}});
  addDistances(page, context);
}

}  // namespace tactus::report
