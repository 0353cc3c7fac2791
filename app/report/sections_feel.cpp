// What a hand feels of the averaged model: one stroke (Fig. 13) and a whole placement (Fig. 18), both simulated.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "app/report/palette.h"
#include "app/report/report_sections.h"
#include "app/simulation/scenario_run.h"
#include "core/base/text.h"
#include "core/render/friction.h"

namespace tactus::report {

namespace {

using simulation::TraceTick;

struct FeltRun {
  std::string setting;  ///< ` at <its conditions>, and how they change`; empty without conditions
  std::vector<TraceTick> ticks;
  simulation::RunSummary summary;
};

/// A scenario of another procedure, in the way and under the usual conditions of `context`.
void adapt(simulation::Scenario& scenario, const ReportContext& context) {
  constexpr double kStartShare = 0.25;   // of the way, where the one stroke begins
  constexpr double kPushedShare = 1.1;   // of the way, in all strokes of a placement
  constexpr double kStrokeShare = 0.15;  // of the way, at most in one stroke
  const auto& inputs = context.in.built.model.inputs;
  const fuzzy::Variable& way = depthVariable(context.in.built.model);
  const double length_mm = way.max - way.min;
  scenario.events.clear();
  scenario.conditions.clear();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (fuzzy::roleOf(inputs[i]) == fuzzy::Role::kCondition) scenario.conditions[inputs[i].id] = context.usual[i];
  }
  if (scenario.start_depth_mm > 0) scenario.start_depth_mm = kStartShare * length_mm;
  double strokes = 0;
  for (const auto& step : scenario.motion) {
    strokes += step.kind == simulation::MotionStep::Kind::kStroke && step.length_mm > 0 ? 1 : 0;
  }
  const double longest_mm = std::min(kStrokeShare, kPushedShare / strokes) * length_mm;
  for (auto& step : scenario.motion) {
    if (step.kind == simulation::MotionStep::Kind::kStroke && step.length_mm != 0)
      step.length_mm = std::copysign(std::min(std::abs(step.length_mm), longest_mm), step.length_mm);
  }
}

/// ` at tube lubrication 0.80, neck flexion angle 20 deg; after 4.5 s neck flexion angle 80 deg within 1 s`.
std::string settingOf(const simulation::Scenario& scenario, const ReportContext& context) {
  const auto& inputs = context.in.built.model.inputs;
  const auto values = [&inputs](const haptics::Conditions& conditions) {
    std::vector<std::string> parts;
    for (const fuzzy::Variable& input : inputs) {
      if (const auto value = conditions.find(input.id); value != conditions.end())
        parts.push_back(valueText(input, value->second));
    }
    return base::joined(parts, ", ");
  };
  const std::string first = values(scenario.conditions);
  std::string out = first.empty() ? first : " at " + first;
  for (const simulation::ScenarioEvent& event : scenario.events) {
    if (const std::string changed = values(event.conditions); !changed.empty())
      out += "; after " + base::formatNumber(event.at_s) + " s " + changed + " within " +
             base::formatNumber(event.fade_s) + " s";
  }
  return out;
}

std::optional<FeltRun> feel(std::string_view scenario_json, const ReportContext& context) {
  auto scenario = simulation::parseScenario(scenario_json);
  if (!scenario) return std::nullopt;
  const fuzzy::ForceModel& model = context.in.built.model;
  const bool has_its_conditions =
      std::all_of(scenario->conditions.begin(), scenario->conditions.end(), [&model](const auto& condition) {
        return std::any_of(model.inputs.begin(), model.inputs.end(),
                           [&condition](const fuzzy::Variable& input) { return input.id == condition.first; });
      });
  if (!has_its_conditions) adapt(*scenario, context);
  FeltRun run;
  run.setting = settingOf(*scenario, context);
  const auto summary = simulation::runScenario(
      *scenario, model,
      [](const std::string& path) -> base::Result<fuzzy::ForceModel> {
        return base::fail(base::ErrorCode::kReference, path, "another model", "none");
      },
      [&run](const TraceTick& tick) { run.ticks.push_back(tick); });
  if (!summary) return std::nullopt;
  run.summary = *summary;
  return run;
}

double secondsOf(const TraceTick& tick) { return static_cast<double>(tick.sample.time_ns) / 1e9; }

/// A multiple of 0.1 N above `force_n`, with room for a text.
double axisTop(double force_n) { return std::ceil(1.15 * force_n * 10) / 10; }

PlotAxis axisTo(double max, std::string label) {
  PlotAxis axis;
  axis.label = std::move(label);
  axis.max = max;
  return axis;
}

/// Force over the way of the hand since the press.
std::string strokePlot(const FeltRun& run, const fuzzy::RendererParameters& friction) {
  Series felt, model, printed;
  std::optional<double> start_mm;
  bool slipped = false;
  double largest_mm = 0;
  const std::uint32_t last_stroke = run.ticks.back().sample.stroke;
  for (const auto& tick : run.ticks) {
    const auto& s = tick.sample;
    if (s.phase == render::Phase::kReleased || s.stroke != last_stroke) continue;
    if (!start_mm) start_mm = tick.true_position_mm;
    const double way_mm = tick.true_position_mm - *start_mm;
    if (way_mm < largest_mm) continue;  // forwards only: the paper's sketch shows no return
    largest_mm = way_mm;
    slipped = slipped || s.phase == render::Phase::kSlidingIn;
    felt.push_back({way_mm, s.force_n});
    if (slipped) model.push_back({way_mm, s.model_force_n});
    const double static_n =
        render::printedStaticFriction(friction.stiffness_n_mm, way_mm, friction.damping_n_s_mm, tick.true_speed_mm_s);
    printed.push_back({way_mm, slipped ? std::nullopt : std::optional(static_n)});
  }
  SvgPlot plot({.title = "Static and dynamic friction during one stroke",
                .description = "Resistance over the way of the hand since the press.",
                .width = 940,
                .height = 320,
                .x = axisTo(std::max(1.0, largest_mm), "Way of the hand since the press (mm)"),
                .y = axisTo(axisTop(run.summary.largest_force_n), "Resistance (N)"),
                .simulated = true});
  plot.line(model, {.color = kSky, .width = 4}, "Fuzzy force F_d");
  plot.line(felt, {.color = kInk, .width = 1.8}, "Felt by the hand");
  plot.line(printed, {.color = kVermilion, .width = 1.8, .dash = Dash::kDashed}, "Eq. 3 as printed, kX − μV");
  return plot.svg();
}

std::string placementForcePlot(const FeltRun& run) {
  Series felt, sliding;
  for (const auto& tick : run.ticks) {
    const double time_s = secondsOf(tick);
    felt.push_back({time_s, tick.sample.force_n});
    const bool slides = tick.sample.phase == render::Phase::kSlidingIn;
    sliding.push_back({time_s, slides ? std::optional(tick.sample.force_n) : std::nullopt});
  }
  SvgPlot plot({.title = "Force over a whole placement",
                .description = "Resistance over time.",
                .width = 940,
                .height = 280,
                .x = axisTo(run.summary.duration_s, "Time (s)"),
                .y = axisTo(axisTop(run.summary.largest_force_n), "Resistance (N)"),
                .simulated = true});
  plot.line(felt, {.color = kMuted, .width = 1.2}, "Tube stuck, or let go");
  plot.line(sliding, {.color = kBlue, .width = 1.6}, "Tube slides in");
  return plot.svg();
}

/// Depth of the tube over time, the regions along the axis.
std::string placementDepthPlot(const FeltRun& run, const ReportContext& context) {
  Series depth;
  for (const auto& tick : run.ticks) depth.push_back({secondsOf(tick), tick.sample.depth_mm});
  SvgPlot plot({.title = "Depth of the tube over a whole placement",
                .description = "Depth over time; the horizontal lines are the ends of the regions.",
                .width = 940,
                .height = 260,
                .x = axisTo(run.summary.duration_s, "Time (s)"),
                .y = depthAxis(context),
                .simulated = true});
  for (const Region& region : context.regions) {
    plot.line({{0, region.from_mm}, {run.summary.duration_s, region.from_mm}}, {.color = kGrid, .width = 1});
    plot.label(run.summary.duration_s * 0.995, (region.from_mm + region.to_mm) / 2, region.label, kMuted,
               TextAnchor::kEnd);
  }
  plot.line(depth, {.color = kInk, .width = 2}, "Depth of the tube");
  return plot.svg();
}

}  // namespace

void addFeel(HtmlPage& page, const ReportContext& context) {
  const auto& model = context.in.built.model;
  const auto stroke = feel(simulation::oneStrokeScenarioJson(), context);
  const auto placement = feel(simulation::placementScenarioJson(), context);
  if (!stroke || !placement) return;
  const auto friction = model.renderer.value_or(fuzzy::RendererParameters{});
  page.section("What the hand feels");
  page.paragraph(
      "The averaged model on the renderer and servo that a real device gets, with a simulated device and a simulated "
      "hand. Distances and forces are along the insertion axis.");
  page.figure(
      {.caption = strong(context.demo != nullptr ? "Fig. 13, computed." : "One stroke.") + " " +
                  badges({Badge::kComputed, Badge::kSimulated}) +
                  " One stroke: static friction rises to F_m = (1 + τ) F_d, the tube slips, and the friction falls "
                  "to the fuzzy force F_d. Eq. 3 as printed lowers the resistance while the hand moves (negative "
                  "damping, which feeds energy into the hand); it is drawn here and never rendered. The renderer "
                  "resists with kz + μv. With μ = " +
                  base::formatFixed(friction.damping_n_s_mm, 4) + " N s/mm the two differ little.",
       .panels = {{.svg = strokePlot(*stroke, friction)}}});
  const auto& felt = placement->summary;
  page.figure({.caption = strong(context.demo != nullptr ? "Fig. 18, computed." : "A whole placement.") + " " +
                          badges({Badge::kComputed, Badge::kSimulated}) + " A whole placement in " +
                          std::to_string(felt.strokes) + " strokes" + placement->setting + ". The tube advanced " +
                          base::formatFixed(felt.depth_mm, 0) + " mm of the " + base::formatFixed(felt.planned_mm, 0) +
                          " mm that the hand wanted to push: the rest is the give of tube and hand before each slip. "
                          "Largest resistance " +
                          base::formatFixed(felt.largest_force_n, 2) + " N, mean while sliding " +
                          base::formatFixed(felt.mean_sliding_n, 2) + " N. Of " + std::to_string(felt.ticks) +
                          " ticks " + std::to_string(felt.scene.asked) + " needed the model.",
               .panels = {{.heading = "(a) Resistance", .svg = placementForcePlot(*placement)},
                          {.heading = "(b) Depth", .svg = placementDepthPlot(*placement, context)}}});
}

void addDuels(HtmlPage& page, const ReportContext& context) {
  const auto& duels = context.in.duels;
  if (duels.empty()) return;
  page.section("Blind comparisons by hand");
  Table table{.caption = strong("Blind comparisons.") +
                         " Two models in one hand, as the first and the second stroke, in both orders; neither the "
                         "person nor the screens knew which was which. Trials of one person are not independent of "
                         "each other, so nothing is pooled over persons.",
              .head = {{{.text = "Participant"},
                        {.text = "A"},
                        {.text = "B"},
                        {.text = "Stroke"},
                        numberCell("Trials", true),
                        {.text = "What it shows"}}},
              .body = {}};
  for (const auto& [participant, start, verdict] : duels) {
    const bool own = start.rule == study::DuelRule::kOwnJnd;
    table.body.push_back({headingCell(participant + (start.setting.simulated ? " (simulated)" : "")),
                          {.text = start.a.name},
                          {.text = own ? "–" : start.b.name},
                          {.text = base::formatNumber(start.from_mm) + " to " + base::formatNumber(start.to_mm) +
                                   " mm at " + base::formatNumber(start.speed_mm_s) + " mm/s"},
                          numberCell(std::to_string(verdict.trials), true),
                          {.text = sentenceOf(start, verdict)}});
  }
  page.table(table);
}

}  // namespace tactus::report
