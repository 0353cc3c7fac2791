// What each expert does to the mean, in newtons.
#include <algorithm>
#include <string>

#include "app/report/palette.h"
#include "app/report/report_sections.h"
#include "core/base/text.h"
#include "elicitation/agreement/expert_influence.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::report {

namespace {

constexpr CurveSetting kSetting{1, 60, 50};

/// The averaged force at one depth without the expert `left_out`; nothing where the others have none.
std::optional<double> withoutExpert(const ReportContext& context, double depth_mm, std::size_t left_out) {
  const std::vector<double> weight = normalizedWeights(context.in.built.model);
  double sum = 0;
  double weights = 0;
  for (std::size_t e = 0; e < weight.size(); ++e) {
    const auto force_n = e == left_out ? std::nullopt : context.curves->force(kSetting, depth_mm, e);
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
  const ForceCurve mean = context.curves->plotted(kSetting, std::nullopt);
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
  page.figure(
      {.caption = strong("The mean without each expert, over depth.") + " " +
                  marks(context, {Badge::kComputed, Badge::kSimulated}) +
                  " At the setting of Fig. 11 (50 mm/s, lubrication 1, neck flexion 60 deg). In the blue band a "
                  "hand would not feel the change.",
       .panels = {{.svg = influencePlot(context)}}});
  addDistances(page, context);
}

}  // namespace tactus::report
