#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/palette.h"
#include "app/report/report_sections.h"
#include "core/base/statistics.h"
#include "core/base/text.h"

namespace tactus::report {

namespace {

constexpr int kBins = 36;
constexpr int kCurvePoints = 200;

const fuzzy::Variable& speedVariable(const ReportContext& context) {
  const auto& inputs = context.in.built.model.inputs;
  return *std::find_if(inputs.begin(), inputs.end(), [](const auto& input) { return input.id == "speed"; });
}

std::string termLabel(const fuzzy::Variable& speed, std::size_t index) {
  return index < speed.terms.size() ? speed.terms[index].label : "Cluster " + std::to_string(index + 1);
}

/// Histogram of one participant's samples with the memberships of the clusters.
std::string clusterPlot(const ReportContext& context, const elicitation::ParticipantSpeeds& subject) {
  double max_mm_s = 0;
  for (const study::SpeedSample& sample : context.in.study.speeds) {
    if (sample.participant == subject.participant) max_mm_s = std::max(max_mm_s, sample.speed_mm_s);
  }
  max_mm_s = std::max(10.0, std::ceil(max_mm_s / 10) * 10);
  std::vector<double> edges, counts(kBins, 0.0);
  for (int i = 0; i <= kBins; ++i) edges.push_back(max_mm_s * i / kBins);
  for (const study::SpeedSample& sample : context.in.study.speeds) {
    if (sample.participant != subject.participant || sample.speed_mm_s < 0) continue;
    counts[std::min<std::size_t>(kBins - 1, static_cast<std::size_t>(sample.speed_mm_s / max_mm_s * kBins))] += 1;
  }
  const double fullest = std::max(1.0, *std::max_element(counts.begin(), counts.end()));
  for (double& count : counts) count /= fullest;

  SvgPlot plot({.title = "Speed clusters of " + subject.participant,
                .description = "Histogram of the simulated samples and membership in the clusters.",
                .width = 460,
                .height = 250,
                .x = {.label = "Speed (mm/s)", .min = 0, .max = max_mm_s},
                .y = {.label = "Membership", .min = 0, .max = 1, .ticks = {0, 0.25, 0.5, 0.75, 1}}});
  plot.bars(edges, counts, "#D5DBE1", "Samples");
  const std::vector<double>& centres = subject.clusters.centres;
  std::vector<Series> memberships(centres.size());
  std::vector<double> at(centres.size());
  for (int i = 0; i <= kCurvePoints; ++i) {
    const double speed_mm_s = max_mm_s * i / kCurvePoints;
    elicitation::fcmMemberships(speed_mm_s, centres, subject.clusters.m, at);
    for (std::size_t k = 0; k < centres.size(); ++k) memberships[k].push_back({speed_mm_s, at[k]});
  }
  constexpr std::array<Dash, 3> kDashes = {Dash::kSolid, Dash::kDashed, Dash::kDashDot};
  for (std::size_t k = 0; k < centres.size(); ++k) {
    plot.line(memberships[k], {.color = seriesColor(k), .width = 2, .dash = kDashes[k % kDashes.size()]},
              termLabel(speedVariable(context), k));
    plot.verticalRule(centres[k], {.color = seriesColor(k), .width = 1, .dash = Dash::kDotted});
  }
  return plot.svg();
}

Table clusterTable(const ReportContext& context) {
  Table table{
      .caption = strong("Cluster centres and ramps.") + " " + badges({Badge::kComputed, Badge::kSimulated}) +
                 " Fuzzy C-Means of each participant’s simulated samples, in mm/s. A ramp falls from 1 at p to 0 "
                 "at q; the next term rises there.",
      .head = {{{.text = ""},
                {.text = "Centres", .columns = 3, .group_start = true},
                {.text = "Ramp slow, medium", .columns = 2, .group_start = true},
                {.text = "Ramp medium, fast", .columns = 2, .group_start = true},
                {.text = "Clusters against levels", .columns = 2, .group_start = true},
                {.text = "", .group_start = true}},
               {{.text = "Participant"},
                numberCell("slow", true),
                numberCell("medium"),
                numberCell("fast"),
                numberCell("p", true),
                numberCell("q"),
                numberCell("p", true),
                numberCell("q"),
                numberCell("adj. Rand", true),
                numberCell("accuracy"),
                numberCell("steps", true)}},
      .body = {}};
  std::array<std::vector<double>, 7> columns;
  for (const elicitation::ParticipantSpeeds& subject : context.in.built.speeds) {
    if (subject.clusters.centres.size() != 3 || subject.ramps.size() != 2) continue;
    const std::array<double, 7> values = {
        subject.clusters.centres[0], subject.clusters.centres[1], subject.clusters.centres[2], subject.ramps[0].p,
        subject.ramps[0].q,          subject.ramps[1].p,          subject.ramps[1].q};
    std::vector<Cell> row = {headingCell(subject.participant)};
    for (std::size_t i = 0; i < values.size(); ++i) {
      columns[i].push_back(values[i]);
      row.push_back(numberCell(base::formatFixed(values[i], 1), i == 0 || i == 3 || i == 5));
    }
    row.push_back(numberCell(base::formatFixed(subject.confusion.adjusted_rand_index, 2), true));
    row.push_back(numberCell(base::formatFixed(subject.confusion.accuracy, 2)));
    row.push_back(numberCell(std::to_string(subject.clusters.iterations), true));
    table.body.push_back(std::move(row));
  }
  if (!columns[0].empty()) {
    std::vector<Cell> row = {headingCell("Mean")};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      row.push_back(numberCell(strong(base::formatFixed(base::mean(columns[i]), 1)), i == 0 || i == 3 || i == 5));
    }
    row.push_back({.text = "", .columns = 2, .group_start = true});
    row.push_back({.text = "", .group_start = true});
    table.body.push_back(std::move(row));
  }
  table.note =
      "Clusters know nothing of the level a participant was asked for. Adjusted Rand index and accuracy say how far "
      "the two "
      "agree (1 is perfect).";
  return table;
}

/// The trapezoids from ramps as one series with gaps between the terms.
Series trapezoids(const std::vector<elicitation::Ramp>& ramps, double max_mm_s) {
  Series out;
  for (std::size_t term = 0; term <= ramps.size(); ++term) {
    if (term == 0) {
      out.push_back({0, 1.0});
    } else {
      out.push_back({ramps[term - 1].p, 0.0});
      out.push_back({ramps[term - 1].q, 1.0});
    }
    if (term == ramps.size()) {
      out.push_back({max_mm_s, 1.0});
    } else {
      out.push_back({ramps[term].p, 1.0});
      out.push_back({ramps[term].q, 0.0});
    }
    out.push_back({max_mm_s, std::nullopt});
  }
  return out;
}

std::string rampPlot(const ReportContext& context) {
  const fuzzy::Variable& speed = speedVariable(context);
  SvgPlot plot({.title = "Speed terms of each participant and their average",
                .description = "Ramps between the clusters of each participant, and the averaged trapezoids.",
                .width = 940,
                .height = 300,
                .x = {.label = "Insertion speed (mm/s)", .min = speed.min, .max = speed.max},
                .y = {.label = "Membership", .min = 0, .max = 1.12, .ticks = {0, 0.25, 0.5, 0.75, 1}}});
  for (std::size_t i = 0; i < context.in.built.speeds.size(); ++i) {
    LineLook look = expertLook(i);
    look.width = 1.5;
    plot.line(trapezoids(context.in.built.speeds[i].ramps, speed.max), look, context.in.built.speeds[i].participant);
  }
  Series average;
  for (const fuzzy::Term& term : speed.terms) {
    if (term.shape != fuzzy::Shape::kTrapezoid) continue;
    const auto& p = term.points;
    for (std::size_t i = 0; i < p.size(); ++i) average.push_back({p[i], i == 0 || i == 3 ? 0.0 : 1.0});
    average.push_back({p[3], std::nullopt});
    const double core = (std::max(p[1], speed.min) + std::min(p[2], speed.max)) / 2;
    plot.label(core, 1.04, term.label, kInk);
  }
  plot.line(average, {.color = kInk, .width = 3}, "Terms of the model");
  return plot.svg();
}

}  // namespace

void addClusters(HtmlPage& page, const ReportContext& context) {
  if (context.in.built.speeds.empty()) return;
  page.section("Speed clusters and terms");
  Figure figure{
      .caption = strong("Fig. 7, recomputed.") + " " + badges({Badge::kComputed, Badge::kSimulated}) +
                 " Clusters of the simulated speeds. Grey: histogram of the samples, scaled to its fullest bin. "
                 "Lines: membership in each cluster; dotted: its centre.",
      .panels = {},
      .columns = 2};
  char letter = 'a';
  for (const elicitation::ParticipantSpeeds& subject : context.in.built.speeds) {
    figure.panels.push_back(
        {.heading = std::string("(") + letter++ + ") " + subject.participant, .svg = clusterPlot(context, subject)});
  }
  page.figure(figure);
  page.table(clusterTable(context));
  page.figure(
      {.caption = strong("Fig. 8 and 3(d), recomputed.") + " " + badges({Badge::kComputed, Badge::kSimulated}) +
                  " Ramps of each participant and the trapezoids averaged from them, which are the model’s terms "
                  "of the speed.",
       .panels = {{.svg = rampPlot(context)}}});
}

}  // namespace tactus::report
