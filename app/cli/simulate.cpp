#include <filesystem>

#include "app/cli/commands.h"
#include "app/cli/output_file.h"
#include "app/cli/terminal.h"
#include "app/simulation/scenario_run.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"

namespace tactus::cli {
namespace {

using base::formatFixed;
using base::Result;
using simulation::RunSummary;

std::string count(std::uint64_t number) { return std::to_string(number); }

/// A hand that does not hold the device is no limit that acts.
bool acted(const RunSummary& run, std::size_t bit) {
  return run.limits[bit].times > 0 && 1U << bit != haptics::kLimitedByRelease;
}

double secondsOf(const simulation::LimitSeen& seen) { return static_cast<double>(seen.ticks) / 1000; }

/// `fade_in once, 1.000 s; cap 3 times, 0.412 s`, or `none`.
std::string limitsOf(const RunSummary& run) {
  std::string text;
  for (std::size_t bit = 0; bit < run.limits.size(); ++bit) {
    if (!acted(run, bit)) continue;
    const auto& seen = run.limits[bit];
    text += (text.empty() ? "" : "; ") + std::string(haptics::kLimitNames[bit]) + ' ' +
            (seen.times == 1 ? "once" : std::to_string(seen.times) + " times") + ", " +
            formatFixed(secondsOf(seen), 3) + " s";
  }
  return text.empty() ? "none" : text;
}

std::string asText(const SimulateOptions& options, const RunSummary& run) {
  std::string text = base::oneLine(options.out) + ": simulated, " + base::formatNumber(run.duration_s) + " s, " +
                     count(run.ticks) + " ticks\n";
  text += "  strokes in which the tube slid " + std::to_string(run.strokes) + ", tube at " +
          formatFixed(run.depth_mm, 2) + " mm: advanced " + formatFixed(run.depth_mm - run.start_depth_mm, 2) + " of " +
          formatFixed(run.planned_mm, 2) + " mm that the hand wanted to push\n";
  text += "  largest force " + formatFixed(run.largest_force_n, 3) + " N, mean while sliding in " +
          formatFixed(run.mean_sliding_n, 3) + " N, largest step in 1 ms " + formatFixed(run.largest_step_n, 3) +
          " N\n";
  text += "  changes between stuck and sliding " + std::to_string(run.transitions) + ", ticks without a rule " +
          count(run.held_ticks) + '\n';
  text += "  model asked in " + count(run.scene.asked) + " ticks; not needed in " + count(run.scene.released) +
          " released and " + count(run.scene.unchanged) + " unchanged\n";
  text += wrapped(limitsOf(run), "  limits that acted: ", 4);
  for (const auto& seen : run.trips) {
    text += wrapped("at " + base::formatNumber(seen.at_s) + " s: " + haptics::sentence(seen.trip), "  trip: ", 8);
  }
  return text;
}

std::string asJson(const SimulateOptions& options, const RunSummary& run) {
  base::JsonWriter json;
  json.beginObject().key("trace").value(options.out).key("simulated").value(true);
  json.key("duration_s").value(run.duration_s).key("ticks").value(std::size_t{run.ticks});
  json.key("strokes")
      .value(run.strokes)
      .key("start_depth_mm")
      .value(run.start_depth_mm)
      .key("depth_mm")
      .value(run.depth_mm);
  json.key("planned_mm").value(run.planned_mm).key("largest_force_n").value(run.largest_force_n);
  json.key("mean_sliding_n").value(run.mean_sliding_n).key("largest_step_n").value(run.largest_step_n);
  json.key("transitions").value(run.transitions).key("held_ticks").value(std::size_t{run.held_ticks});
  json.key("inference").beginObject(base::JsonWriter::Layout::kInline);
  json.key("asked").value(std::size_t{run.scene.asked}).key("released").value(std::size_t{run.scene.released});
  json.key("unchanged").value(std::size_t{run.scene.unchanged}).endObject();
  json.key("trips").beginArray();
  for (const auto& seen : run.trips) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("at_s").value(seen.at_s);
    json.key("cause").value(haptics::describe(seen.trip.cause)).key("value").value(seen.trip.value);
    json.key("limit").value(seen.trip.limit).key("sentence").value(haptics::sentence(seen.trip)).endObject();
  }
  json.endArray().key("limits").beginArray();
  for (std::size_t bit = 0; bit < run.limits.size(); ++bit) {
    if (!acted(run, bit)) continue;
    json.beginObject(base::JsonWriter::Layout::kInline).key("limit").value(haptics::kLimitNames[bit]);
    json.key("times").value(run.limits[bit].times).key("seconds").value(secondsOf(run.limits[bit])).endObject();
  }
  return json.endArray().endObject().text();
}

/// One sentence for each condition that the model clamps.
std::vector<std::string> clamped(const simulation::Scenario& scenario, const fuzzy::ForceModel& model) {
  std::vector<std::string> warnings;
  const auto look = [&](const haptics::Conditions& conditions, const std::string& place) {
    for (const auto& input : model.inputs) {
      const auto it = conditions.find(input.id);
      if (it == conditions.end() || (it->second >= input.min && it->second <= input.max)) continue;
      warnings.push_back(place + "/conditions/" + input.id + ": " + base::formatNumber(it->second) +
                         " is outside the model's universe [" + base::formatNumber(input.min) + ", " +
                         base::formatNumber(input.max) + "] and is taken as its end");
    }
  };
  look(scenario.conditions, {});
  for (const auto& event : scenario.events) look(event.conditions, event.place);
  return warnings;
}

}  // namespace

Result<Output> simulate(const SimulateOptions& options) {
  if (auto kept = requireOutput(options.out, {options.model, options.scenario}); !kept)
    return tl::unexpected(kept.error());
  TACTUS_TRY(auto read, model_io::readModel(options.model));
  TACTUS_TRY(const auto scenario, simulation::readScenario(options.scenario));

  Output output{{}, std::move(read.warnings)};
  for (auto& warning : clamped(scenario, read.model)) output.warnings.push_back(options.scenario + ": " + warning);
  const auto folder = std::filesystem::path(options.scenario).parent_path();
  const auto read_other = [&](const std::string& path) -> Result<fuzzy::ForceModel> {
    TACTUS_TRY(auto other, model_io::readModel((folder / path).string()));
    output.warnings.insert(output.warnings.end(), other.warnings.begin(), other.warnings.end());
    return std::move(other.model);
  };
  simulation::TraceTable trace(scenario.conditions);
  const auto run = simulation::runScenario(scenario, read.model, read_other,
                                           [&trace](const simulation::TraceTick& tick) { trace.add(tick); });
  if (!run) return base::inFile(run.error(), options.scenario);
  output.text = options.json ? asJson(options, *run) : asText(options, *run);
  return written(options.out, trace.text(), std::move(output), options.json);
}

}  // namespace tactus::cli
