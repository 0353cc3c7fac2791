#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/palette.h"
#include "app/report/report_sections.h"
#include "core/base/statistics.h"
#include "core/base/text.h"

namespace tactus::report {
namespace {

using base::formatFixed;
using elicitation::Interval;
using elicitation::ParticipantSpeeds;

std::size_t termCount(const ReportContext& context) { return speedVariable(context).terms.size(); }

/// Whether the participant has a center for each term of the speed and a ramp between neighbors.
bool hasAllTerms(const ReportContext& context, const ParticipantSpeeds& subject) {
  return subject.centres.size() == termCount(context) && subject.ramps.size() + 1 == subject.centres.size();
}

/// Whether the value at this place begins a group: the centers, then the two ends of each ramp.
bool startsGroup(const ReportContext& context, std::size_t value) {
  const std::size_t terms = termCount(context);
  return value == 0 || (value >= terms && (value - terms) % 2 == 0);
}

std::vector<std::vector<Cell>> valueHead(const ReportContext& context) {
  const auto& terms = speedVariable(context).terms;
  const auto name = [&terms](std::size_t i) { return base::lowered(terms[i].label); };
  std::vector<Cell> groups = {{.text = ""},
                              {.text = "Centers", .columns = static_cast<int>(terms.size()), .group_start = true}};
  std::vector<Cell> values = {{.text = "Participant"}};
  for (std::size_t i = 0; i < terms.size(); ++i) values.push_back(numberCell(name(i), i == 0));
  for (std::size_t i = 0; i + 1 < terms.size(); ++i) {
    groups.push_back({.text = "Ramp " + name(i) + ", " + name(i + 1), .columns = 2, .group_start = true});
    values.push_back(numberCell("p", true));
    values.push_back(numberCell("q"));
  }
  return {std::move(groups), std::move(values)};
}

Table clusterTable(const ReportContext& context) {
  Table table{.caption = strong("Cluster centers and ramps.") + " " +
                         marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " Fuzzy C-Means of each participant’s samples, in mm/s. A ramp falls from 1 at p to 0 "
                         "at q; the next term rises there.",
              .head = valueHead(context),
              .body = {}};
  std::vector<std::vector<double>> columns(3 * termCount(context) - 2);
  for (const ParticipantSpeeds& subject : context.in.built.speeds) {
    if (!hasAllTerms(context, subject)) continue;
    std::vector<double> values = subject.centres;
    for (const auto& ramp : subject.ramps) values.insert(values.end(), {ramp.p, ramp.q});
    std::vector<Cell> row = {headingCell(subject.participant)};
    for (std::size_t i = 0; i < values.size(); ++i) {
      columns[i].push_back(values[i]);
      row.push_back(numberCell(formatFixed(values[i], 1), startsGroup(context, i)));
    }
    table.body.push_back(std::move(row));
  }
  if (!columns[0].empty()) {
    std::vector<Cell> row = {headingCell("Mean")};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      row.push_back(numberCell(strong(formatFixed(base::mean(columns[i]), 1)), startsGroup(context, i)));
    }
    table.body.push_back(std::move(row));
  }
  return table;
}

Cell intervalCell(const Interval& interval, bool group_start) {
  return numberCell(formatFixed(interval.low, 1) + "–" + formatFixed(interval.high, 1), group_start);
}

void addRamps(std::vector<Cell>& row, const std::vector<elicitation::RampInterval>& ramps) {
  for (const elicitation::RampInterval& ramp : ramps) {
    row.push_back(intervalCell(ramp.p, true));
    row.push_back(intervalCell(ramp.q, false));
  }
}

Table intervalTable(const ReportContext& context) {
  const auto& intervals = *context.speed_intervals;
  Table table{.caption = strong("95 % intervals.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) + " " +
                         std::to_string(intervals.replicates) +
                         " draws of whole strokes within each level, with replacement; Student’s t times the standard "
                         "deviation of the draws, widened for few strokes; in mm/s.",
              .head = valueHead(context),
              .body = {}};
  for (std::size_t who = 0; who < context.in.built.speeds.size(); ++who) {
    const ParticipantSpeeds& subject = context.in.built.speeds[who];
    if (!hasAllTerms(context, subject)) continue;
    const auto& own = intervals.participants[who];
    std::vector<Cell> row = {headingCell(subject.participant)};
    for (std::size_t i = 0; i < own.centres.size(); ++i) row.push_back(intervalCell(own.centres[i], i == 0));
    addRamps(row, own.ramps);
    table.body.push_back(std::move(row));
  }
  if (!intervals.averaged.empty() && intervals.averaged.size() + 1 == termCount(context)) {
    std::vector<Cell> row = {headingCell("Mean"),
                             {.text = "", .columns = static_cast<int>(termCount(context)), .group_start = true}};
    addRamps(row, intervals.averaged);
    table.body.push_back(std::move(row));
  }
  table.note =
      "Samples within a stroke hang together, so strokes are drawn, not samples: intervals from single samples would "
      "be "
      "ten times too narrow. The intervals of the mean say how these participants’ strokes vary, not how other "
      "participants would.";
  return table;
}

/// `text`, in bold where it is something to look at.
Cell markedCell(const std::string& text, bool marked, bool group_start = false) {
  return numberCell(marked ? strong(text) : Markup(text), group_start);
}

std::string pText(const elicitation::LevelTrend& trend) {
  return trend.p < 0.001 ? "< 0.001" : formatFixed(trend.p, 3);
}

Table levelTable(const ReportContext& context) {
  const fuzzy::Variable& speed = speedVariable(context);
  std::vector<Cell> groups = {
      {.text = "", .columns = 2},
      {.text = "Speed", .columns = 3, .group_start = true},
      {.text = "% nearest to the center", .columns = static_cast<int>(speed.terms.size()), .group_start = true},
      {.text = "Agreement", .columns = 2, .group_start = true},
      {.text = "Order of strokes", .columns = 2, .group_start = true},
      {.text = "", .group_start = true}};
  std::vector<Cell> values = {
      {.text = "Participant"}, {.text = "Level"}, numberCell("mean", true), numberCell("SD"), numberCell("d′ to next")};
  for (std::size_t i = 0; i < speed.terms.size(); ++i)
    values.push_back(numberCell(base::lowered(speed.terms[i].label), i == 0));
  for (Cell& cell : std::array<Cell, 5>{numberCell("adj. Rand", true), numberCell("accuracy"), numberCell("J", true),
                                        numberCell("p"), Cell{.text = "Reads as", .group_start = true}}) {
    values.push_back(std::move(cell));
  }
  Table table{.caption = strong("Levels against clusters.") + " " +
                         marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " Commanded levels, measured speeds, and the clusters of the samples. Speeds in mm/s.",
              .head = {std::move(groups), std::move(values)},
              .body = {},
              .wide = true};
  for (const ParticipantSpeeds& subject : context.in.built.speeds) {
    const auto& found = subject.diagnostics;
    if (!hasAllTerms(context, subject)) continue;
    for (std::size_t k = 0; k < found.levels.size(); ++k) {
      const auto& level = found.levels[k];
      std::vector<Cell> row = {headingCell(k == 0 ? subject.participant : ""),
                               {.text = level.level},
                               numberCell(formatFixed(level.mean_mm_s, 1), true),
                               numberCell(formatFixed(level.sd_mm_s, 1))};
      if (k < found.separations.size() && found.separations[k].has_value()) {
        const double separation = found.separations[k].value();
        row.push_back(markedCell(formatFixed(separation, 2), separation < 1));
      } else {
        row.push_back(numberCell(""));
      }
      for (std::size_t cluster = 0; cluster < subject.centres.size(); ++cluster) {
        const auto count = static_cast<double>(found.confusion.counts[k][cluster]);
        const double share = level.samples == 0 ? 0 : 100 * count / static_cast<double>(level.samples);
        row.push_back(numberCell(formatFixed(share, 0), cluster == 0));
      }
      const auto& confusion = found.confusion;
      const bool first = k == 0;
      row.push_back(markedCell(first ? formatFixed(confusion.adjusted_rand_index, 2) : "",
                               confusion.adjusted_rand_index < 0.3, true));
      row.push_back(markedCell(first ? formatFixed(confusion.accuracy, 2) : "", confusion.accuracy < 0.6));
      const bool tested = first && found.trend;
      row.push_back(numberCell(
          tested ? formatFixed(found.trend->j, 0) + " of " + formatFixed(found.trend->most_j, 0) : "", true));
      row.push_back(markedCell(tested ? pText(*found.trend) : "", tested && found.trend->p > 0.05));
      row.push_back({.text = speed.terms[elicitation::termAt(speed, level.mean_mm_s)].label, .group_start = true});
      table.body.push_back(std::move(row));
    }
  }
  table.note =
      "Clusters know nothing of the level a participant was asked for. d′: distance of the means by the pooled SD. "
      "Adjusted Rand index and accuracy: how far clusters and levels agree, 1 is perfect. J, p: Jonckheere-Terpstra "
      "test that the means of the strokes rise with the level, one-sided, over every arrangement of the strokes. Reads "
      "as: the averaged term of the mean speed. Bold: d′ below 1, index below 0.3, accuracy below 0.6, p above 0.05.";
  return table;
}

}  // namespace

void addClusterTables(HtmlPage& page, const ReportContext& context) {
  page.table(clusterTable(context));
  if (context.speed_intervals) page.table(intervalTable(context));
  page.table(levelTable(context));
}

namespace {

constexpr int kBins = 36;
constexpr int kCurvePoints = 200;

std::string termLabel(const fuzzy::Variable& speed, std::size_t index) {
  return index < speed.terms.size() ? speed.terms[index].label : "Cluster " + std::to_string(index + 1);
}

/// A level bar with ends from `low` to `high`, at the height `y`.
void errorBar(SvgPlot& plot, const elicitation::Interval& interval, double y, std::string_view color,
              std::string_view name) {
  constexpr double kEnd = 0.03;
  const LineLook look{.color = color, .width = 2};
  plot.line({{interval.low, y}, {interval.high, y}}, look, name);
  for (const double x : {interval.low, interval.high}) plot.line({{x, y - kEnd}, {x, y + kEnd}}, look);
}

/// Histogram of one participant's samples with the memberships around the centers and the intervals of these.
std::string clusterPlot(const ReportContext& context, const elicitation::ParticipantSpeeds& subject,
                        const elicitation::SpeedIntervals* intervals) {
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
                .description = "Histogram of the samples and membership in the clusters.",
                .width = 460,
                .height = 250,
                .x = {.label = "Speed (mm/s)", .min = 0, .max = max_mm_s},
                .y = {.label = "Membership", .min = 0, .max = 1, .ticks = {0, 0.25, 0.5, 0.75, 1}},
                .simulated = context.simulated(subject.participant)});
  plot.bars(edges, counts, "#D5DBE1", "Samples");
  const std::vector<double>& centres = subject.centres;
  std::vector<Series> memberships(centres.size());
  std::vector<double> at(centres.size());
  for (int i = 0; i <= kCurvePoints; ++i) {
    const double speed_mm_s = max_mm_s * i / kCurvePoints;
    elicitation::fcmMemberships(speed_mm_s, centres, subject.m, at);
    for (std::size_t k = 0; k < centres.size(); ++k) memberships[k].push_back({speed_mm_s, at[k]});
  }
  constexpr std::array<Dash, 3> kDashes = {Dash::kSolid, Dash::kDashed, Dash::kDashDot};
  const fuzzy::Variable& speed = speedVariable(context);
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const std::string color = figures::hex(figures::termColor(speed, speed.terms, k));
    plot.line(memberships[k], {.color = color, .width = 2, .dash = kDashes[k % kDashes.size()]}, termLabel(speed, k));
    plot.verticalRule(centres[k], {.color = color, .width = 1, .dash = Dash::kDotted});
  }
  for (std::size_t k = 0; intervals != nullptr && k < centres.size(); ++k) {
    errorBar(plot, intervals->centres[k], 0.06, kInk, k == 0 ? "95 % interval of a center" : "");
  }
  return plot.svg();
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
                .y = {.label = "Membership", .min = 0, .max = 1.12, .ticks = {0, 0.25, 0.5, 0.75, 1}},
                .simulated = context.simulated()});
  for (std::size_t i = 0; i < context.in.built.speeds.size(); ++i) {
    LineLook look = expertLook(i);
    look.width = 1.5;
    const bool each = context.in.built.speeds.size() <= kMostDrawn;
    if (!each) look = {.color = "#B6BEC7", .width = 0.6};
    plot.line(trapezoids(context.in.built.speeds[i].ramps, speed.max), look,
              each     ? context.in.built.speeds[i].participant
              : i == 0 ? "Each participant"
                       : "");
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
  for (std::size_t k = 0; context.speed_intervals && k < context.speed_intervals->averaged.size(); ++k) {
    const elicitation::RampInterval& ramp = context.speed_intervals->averaged[k];
    errorBar(plot, ramp.p, 1, kOrange, k == 0 ? "95 % interval of a corner" : "");
    errorBar(plot, ramp.q, 1, kOrange, "");
  }
  return plot.svg();
}

}  // namespace

const fuzzy::Variable& speedVariable(const ReportContext& context) {
  const auto& inputs = context.in.built.model.inputs;
  return inputs[fuzzy::rateOf(inputs).value()];
}

void addClusters(HtmlPage& page, const ReportContext& context) {
  if (context.in.built.speeds.empty()) return;
  page.section("Speed clusters and terms");
  Figure figure{.caption = strong(context.demo != nullptr ? "Fig. 7, recomputed." : "Clusters of the speeds.") + " " +
                           marks(context, {Badge::kComputed, Badge::kSimulated}) +
                           (context.demo != nullptr ? " Clusters of the simulated speeds."
                                                    : " Fuzzy C-Means of each participant.") +
                           " Gray: histogram of the samples, scaled to its fullest bin. "
                           "Lines: membership in each cluster; dotted: its center, with its 95 % interval at the foot.",
                .panels = {},
                .columns = 2};
  char letter = 'a';
  for (std::size_t who = 0; who < context.in.built.speeds.size(); ++who) {
    const elicitation::ParticipantSpeeds& subject = context.in.built.speeds[who];
    if (who == kMostDrawn) {
      figure.caption += " The first " + std::to_string(kMostDrawn) + " of " +
                        std::to_string(context.in.built.speeds.size()) + " participants are drawn.";
      break;
    }
    const auto* intervals = context.speed_intervals ? &context.speed_intervals->participants[who] : nullptr;
    figure.panels.push_back({.heading = std::string("(") + letter++ + ") " + subject.participant,
                             .svg = clusterPlot(context, subject, intervals)});
  }
  page.figure(figure);
  addClusterTables(page, context);
  page.figure(
      {.caption = strong(context.demo != nullptr ? "Fig. 8 and 3(d), recomputed." : "Terms of the speed.") + " " +
                  marks(context, {Badge::kComputed, Badge::kSimulated}) +
                  " Ramps of each participant and the trapezoids averaged from them, which are the model’s terms "
                  "of the speed. Bars: 95 % intervals of their corners.",
       .panels = {{.svg = rampPlot(context)}}});
}

}  // namespace tactus::report
