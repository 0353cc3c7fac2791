#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/output_file.h"
#include "app/cli/study_text.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/store/duel_records.h"
#include "elicitation/force/noticeable_force.h"
#include "experiments/duel_run.h"
#include "experiments/two_interval.h"

namespace tactus::cli {
namespace {

using base::ErrorCode;
using base::formatFixed;
using base::formatNumber;
using base::JsonWriter;
using base::Result;
using elicitation::StrokeDifference;
using experiments::BinomialTest;
using experiments::DuelVerdict;
using experiments::SequentialTest;
using study::DuelRule;
using study::DuelStart;

constexpr double kNearJnd = 0.25;  // an own JND this near to the truth counts as found

std::string percent(double share, int digits = 1) { return formatFixed(100 * share, digits) + " %"; }

/// The difference of the two models along the stroke of `options`.
Result<StrokeDifference> strokeOption(const DuelPlanOptions& options, std::vector<std::string>& warnings) {
  TACTUS_TRY(const auto a, openedModel(options.models[0]));
  TACTUS_TRY(const auto b, openedModel(options.models[1]));
  for (const auto* opened : {&a, &b}) warnings.insert(warnings.end(), opened->warnings.begin(), opened->warnings.end());
  const auto& inputs = a.model.inputs;
  const auto depth = std::find_if(inputs.begin(), inputs.end(), [](const auto& input) { return input.id == "depth"; });
  const bool has_depth = depth != inputs.end();
  const auto same = std::equal(inputs.begin(), inputs.end(), b.model.inputs.begin(), b.model.inputs.end(),
                               [](const auto& x, const auto& y) { return x.id == y.id; });
  if (!has_depth || !same) {
    return base::inFile({ErrorCode::kMismatch,
                         {},
                         {},
                         has_depth ? "other inputs" : "no input depth",
                         has_depth ? "the inputs of " + options.models[0] : "a model of the depth"},
                        has_depth ? options.models[1] : options.models[0]);
  }
  if (!(*options.to_mm > *options.from_mm)) {
    return base::fail(ErrorCode::kValue, "--to", formatNumber(*options.to_mm) + " mm",
                      "a depth behind --from " + formatNumber(*options.from_mm) + " mm");
  }
  auto at = options.at;
  at.push_back("depth=" + formatNumber(*options.from_mm));
  TACTUS_TRY(auto point, pointOption(a.model, "--at", at));
  const auto stroke =
      elicitation::strokeDifference(a.compiled, b.compiled, std::move(point),
                                    static_cast<std::size_t>(depth - inputs.begin()), *options.from_mm, *options.to_mm);
  if (stroke.places == 0) {
    return base::fail(ErrorCode::kValue, "stroke", "no place where both models have a force", "another stroke");
  }
  if (stroke.without_one > 0) {
    warnings.push_back(std::to_string(stroke.without_one) + " of " +
                       std::to_string(stroke.places + stroke.without_one) +
                       " places of the stroke have no force in one of the models, and are left out");
  }
  return stroke;
}

/// How a comparison can be done for one difference.
struct DuelChoices {
  double jnd = 0;
  BinomialTest fixed;
  SequentialTest sequential;
  Result<BinomialTest> abx;
};

Result<DuelChoices> choicesFor(double jnd, double power) {
  TACTUS_TRY(const auto fixed, experiments::smallestTest(experiments::shareRight(jnd), power));
  SequentialTest sequential;
  sequential.share_right = experiments::shareRight(jnd);
  sequential.beta = 1 - power;
  sequential.most_trials = std::max(experiments::kMostSequentialTrials, 2 * fixed.trials);
  return DuelChoices{jnd, fixed, sequential, experiments::smallestTest(experiments::abxShareRight(jnd), power)};
}

int catchTrials(int trials) { return static_cast<int>(experiments::duelTrials(trials, 0).size()) - trials; }

std::string asText(const DuelChoices& choices) {
  const BinomialTest& fixed = choices.fixed;
  const double share = experiments::shareRight(choices.jnd);
  const auto with = experiments::chancesOf(choices.sequential, share);
  const auto without = experiments::chancesOf(choices.sequential, 0.5);
  return "A difference of " + formatFixed(choices.jnd, 2) + " JND is told right in " + percent(share) +
         " of the trials.\n\nfixed        " + std::to_string(fixed.trials) + " trials; " +
         std::to_string(fixed.critical) + " right show a difference. Power " + percent(fixed.power) +
         "; without a difference " + percent(fixed.size, 2) +
         ". Catch trials: " + std::to_string(catchTrials(fixed.trials)) + "\nsequential   " +
         formatFixed(with.mean_trials, 1) + " trials on average, " + formatFixed(without.mean_trials, 1) +
         " without a difference, at most " + std::to_string(choices.sequential.most_trials) + ". Power " +
         percent(with.differ) + "; without a difference " + percent(without.differ, 2) + "\nABX          " +
         (choices.abx ? std::to_string(choices.abx->trials) + " trials"
                      : "more than " + std::to_string(experiments::kMostTrials) + " trials") +
         '\n';
}

void write(const DuelChoices& choices, double power, JsonWriter& json) {
  const double share = experiments::shareRight(choices.jnd);
  const auto with = experiments::chancesOf(choices.sequential, share);
  const auto without = experiments::chancesOf(choices.sequential, 0.5);
  json.key("jnd").value(choices.jnd).key("share_right").value(share).key("wanted_power").value(power);
  json.key("trials").value(choices.fixed.trials).key("critical").value(choices.fixed.critical);
  json.key("size").value(choices.fixed.size).key("power").value(choices.fixed.power);
  json.key("catch_trials").value(catchTrials(choices.fixed.trials));
  json.key("sequential").beginObject().key("right_step").value(choices.sequential.rightStep());
  json.key("wrong_step").value(choices.sequential.wrongStep()).key("differ_at").value(choices.sequential.differAt());
  json.key("stop_at").value(choices.sequential.stopAt()).key("most_trials").value(choices.sequential.most_trials);
  json.key("mean_trials").value(with.mean_trials).key("power").value(with.differ);
  json.key("mean_trials_without").value(without.mean_trials).key("size").value(without.differ).endObject();
  json.key("abx").beginObject().key("share_right").value(experiments::abxShareRight(choices.jnd)).key("trials");
  if (choices.abx) {
    json.value(choices.abx->trials).key("critical").value(choices.abx->critical);
  } else {
    json.null();
  }
  json.endObject();
}

std::string strokeText(const StrokeDifference& stroke) {
  return "Along the stroke A and B differ by " + formatFixed(stroke.rms_jnd, 2) + " JND (rms), at most " +
         formatFixed(stroke.largest_jnd, 2) + " JND (" + signedNewtons(stroke.largest_n) + ") at " +
         formatFixed(stroke.at_mm, 0) + " mm.\n";
}

DuelStart simulatedPlan(const DuelSimulateOptions& options) {
  DuelStart start;
  start.a.name = "A";
  start.b.name = "B";
  start.rule = options.rule == "fixed"        ? DuelRule::kFixed
               : options.rule == "sequential" ? DuelRule::kSequential
                                              : DuelRule::kOwnJnd;
  start.to_mm = 60;
  start.speed_mm_s = 60;
  start.trials = options.trials;
  start.sought_jnd = options.sought_jnd;
  return start;
}

/// The verdicts of all runs.
struct SimulatedRuns {
  double found = 0;  ///< share that shows a difference, or an own JND near to the truth
  double mean_trials = 0;
  double marked = 0;
};

SimulatedRuns simulatedRuns(const DuelSimulateOptions& options) {
  DuelStart start = simulatedPlan(options);
  const experiments::DuelResponder responder{options.jnd, options.own_jnd, options.order_bias, options.cant_tell, 0};
  SimulatedRuns out;
  for (int run = 0; run < options.runs; ++run) {
    start.seed = options.seed + static_cast<std::uint64_t>(run);
    const auto verdict = experiments::verdictOf(start, experiments::simulatedAnswers(start, responder, start.seed));
    const bool near = verdict.own && std::abs(verdict.own->factor / options.own_jnd - 1) <= kNearJnd;
    out.found += near || verdict.outcome == DuelVerdict::Outcome::kDiffer ? 1 : 0;
    out.mean_trials += verdict.trials;
    out.marked += verdict.marked ? 1 : 0;
  }
  for (double* sum : {&out.found, &out.mean_trials, &out.marked}) *sum /= options.runs;
  return out;
}

/// The exact chance of what `simulatedRuns` counts, where answers are free of "can't tell" and bias.
std::optional<double> exactChance(const DuelSimulateOptions& options) {
  if (options.cant_tell > 0 || options.order_bias != 0) return std::nullopt;
  const double share = experiments::shareRight(options.jnd / options.own_jnd);
  if (options.rule == "fixed") {
    return experiments::testOf(options.trials, share).power;
  }
  if (options.rule != "sequential") return std::nullopt;
  SequentialTest test;
  test.share_right = experiments::shareRight(options.sought_jnd);
  test.most_trials = options.trials;
  return experiments::chancesOf(test, share).differ;
}

struct Judged {
  store::StoredDuel duel;
  DuelVerdict verdict;
};

std::string asText(const std::vector<Judged>& all) {
  if (all.empty()) return "No blind comparison in this study.\n";
  std::string text;
  for (const auto& [duel, verdict] : all) {
    const DuelStart& start = duel.start;
    text += (text.empty() ? "" : "\n") + base::oneLine(duel.code) + ", " + utcText(start.entry.when.utc_ms) + ": " +
            base::oneLine(start.a.name) + (start.rule == DuelRule::kOwnJnd ? "" : " | " + base::oneLine(start.b.name)) +
            ", " + formatNumber(start.from_mm) + " to " + formatNumber(start.to_mm) + " mm at " +
            formatNumber(start.speed_mm_s) + " mm/s" + (start.setting.simulated ? " (simulated)" : "") + '\n';
    text += wrapped(sentenceOf(start, verdict), "  ", 0);
  }
  return text;
}

void write(const Judged& judged, JsonWriter& json) {
  const auto& [duel, verdict] = judged;
  const DuelStart& start = duel.start;
  json.beginObject().key("id").value(toText(start.entry.id)).key("participant").value(duel.code);
  json.key("utc").value(utcText(start.entry.when.utc_ms)).key("a").value(start.a.name).key("b").value(start.b.name);
  json.key("question").value(store::wordOf(start.question)).key("rule").value(store::wordOf(start.rule));
  json.key("from_mm").value(start.from_mm).key("to_mm").value(start.to_mm).key("speed_mm_s").value(start.speed_mm_s);
  json.key("seed").value(std::size_t{start.seed}).key("simulated").value(start.setting.simulated);
  json.key("gives_force").value(start.gives_force).key("outcome").value(name(verdict.outcome));
  json.key("planned_trials").value(start.trials).key("trials").value(verdict.trials);
  if (verdict.outcome != DuelVerdict::Outcome::kUnfinished) {
    json.key("right").value(verdict.right).key("cant_tell").value(verdict.cant_tell);
    json.key("repeated").value(verdict.repeated).key("critical").value(verdict.critical);
    json.key("share_low").value(verdict.share.low).key("share_high").value(verdict.share.high);
    json.key("detectable_jnd");
    if (std::isfinite(verdict.detectable_jnd)) {
      json.value(verdict.detectable_jnd);
    } else {
      json.null();
    }
    if (verdict.order) json.key("preference").value(verdict.order->preference).key("order").value(verdict.order->order);
    json.key("large").value(verdict.large).key("large_right").value(verdict.large_right);
    json.key("same").value(verdict.same).key("same_named").value(verdict.same_named);
    json.key("marked").value(verdict.marked);
    if (verdict.own) {
      json.key("own_jnd").value(verdict.own->factor).key("own_jnd_low").value(verdict.own->low);
      json.key("own_jnd_high").value(verdict.own->high);
    }
  }
  json.key("sentence").value(sentenceOf(start, verdict)).endObject();
}

/// The trials of finished comparisons: those of others would say who leads.
std::string trialsTable(const std::vector<Judged>& all) {
  base::CsvWriter table({"duel", "participant", "simulated", "trial", "attempt", "kind", "second_first",
                         "difference_jnd", "choice", "repeated", "first_mm_s", "second_mm_s", "response_s"});
  for (const auto& [duel, verdict] : all) {
    if (verdict.outcome == DuelVerdict::Outcome::kUnfinished) continue;
    for (const study::DuelAnswer& answer : duel.answers) {
      table.cell(toText(answer.duel)).cell(duel.code).cell(duel.start.setting.simulated ? 1 : 0).cell(answer.trial);
      table.cell(answer.attempt).cell(store::wordOf(answer.kind)).cell(answer.second_first ? 1 : 0);
      table.cell(answer.difference_jnd).cell(answer.choice ? store::wordOf(*answer.choice) : "");
      table.cell(answer.repeated).cell(answer.first_mm_s).cell(answer.second_mm_s).cell(answer.response_s).endRow();
    }
  }
  return table.text();
}

}  // namespace

Result<Output> duelPlan(const DuelPlanOptions& options) {
  std::vector<std::string> warnings;
  std::optional<StrokeDifference> stroke;
  if (!options.models.empty()) {
    TACTUS_TRY(stroke, strokeOption(options, warnings));
  }
  const double jnd = options.jnd.value_or(stroke ? stroke->rms_jnd : 0);
  auto choices = choicesFor(jnd, options.power);
  if (!choices && !stroke) return tl::unexpected(choices.error());
  if (!choices) {
    warnings.push_back("a difference of " + formatFixed(jnd, 2) + " JND needs more than " +
                       std::to_string(experiments::kMostTrials) + " trials: it is not felt");
  }
  if (options.json) {
    JsonWriter json;
    json.beginObject();
    if (stroke) {
      json.key("stroke").beginObject().key("rms_jnd").value(stroke->rms_jnd);
      json.key("largest_jnd").value(stroke->largest_jnd).key("largest_n").value(stroke->largest_n);
      json.key("at_mm").value(stroke->at_mm).key("mean_n").value(stroke->mean_n).endObject();
    }
    if (choices) {
      write(*choices, options.power, json);
    } else {
      json.key("jnd").value(jnd).key("trials").null();
    }
    return Output{json.endObject().text(), std::move(warnings)};
  }
  return Output{(stroke ? strokeText(*stroke) : "") + (choices ? asText(*choices) : ""), std::move(warnings)};
}

Result<Output> duelSimulate(const DuelSimulateOptions& options) {
  const SimulatedRuns runs = simulatedRuns(options);
  const auto exact = exactChance(options);
  const bool own = options.rule == "own-jnd";
  if (options.json) {
    JsonWriter json;
    json.beginObject().key("simulated").value(true).key("rule").value(options.rule).key("runs").value(options.runs);
    json.key("seed").value(std::size_t{options.seed}).key(own ? "within_25_percent" : "found").value(runs.found);
    json.key("exact").value(exact).key("mean_trials").value(runs.mean_trials).key("marked").value(runs.marked);
    return Output{json.endObject().text(), {}};
  }
  std::string text = std::to_string(options.runs) + " simulated persons, " + formatFixed(runs.mean_trials, 1) +
                     " trials on average: " + percent(runs.found) +
                     (own ? " of the own JNDs are within 25 % of the truth" : " show a difference");
  if (exact) text += " (computed: " + percent(*exact) + ")";
  text += '\n';
  if (runs.marked > 0) text += percent(runs.marked) + " are marked, because large differences were missed\n";
  return Output{std::move(text), {}};
}

Result<Output> duelResults(const DuelResultsOptions& options) {
  if (auto ok = requireOutput(options.out, {options.study}); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(const auto file, store::StudyFile::open(options.study, {store::Access::kReadOnly}));
  TACTUS_TRY(auto stored, store::duels(file));
  std::vector<Judged> all;
  for (auto& duel : stored) {
    // A plan and answers that no run of this program can have are an error, not a verdict.
    const auto run = experiments::DuelRun::create(duel.start, duel.answers);
    if (!run) return base::inFile(run.error(), options.study);
    const DuelVerdict verdict = experiments::verdictOf(duel.start, duel.answers);
    all.push_back({std::move(duel), verdict});
  }
  auto notices = noticesOf(file);
  std::string text = asText(all);
  if (options.json) {
    JsonWriter json;
    json.beginObject().key("file").value(options.study).key("duels").beginArray();
    for (const Judged& judged : all) write(judged, json);
    text = json.endArray().key("notices").values(notices).endObject().text();
  }
  Output said{std::move(text), std::move(notices)};
  if (options.out.empty()) return said;
  return written(options.out, trialsTable(all), std::move(said), options.json);
}

}  // namespace tactus::cli
