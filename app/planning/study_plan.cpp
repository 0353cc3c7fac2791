#include "app/planning/study_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/planning/simulated_people.h"
#include "app/planning/simulated_studies.h"
#include "core/base/in_parallel.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::planning {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr double kFastestMmS = 250;  // insertions are rarely faster
constexpr int kPractice = 2;

double halton(std::size_t index, std::size_t base) {
  double out = 0;
  double share = 1;
  for (; index > 0; index /= base) {
    share /= static_cast<double>(base);
    out += share * static_cast<double>(index % base);
  }
  return out;
}

/// Every so many of them, spread evenly.
std::vector<std::size_t> askedOf(std::size_t items, int questions) {
  std::vector<std::size_t> out;
  for (int i = 0; i < questions; ++i)
    out.push_back(static_cast<std::size_t>((i + 0.5) * static_cast<double>(items) / questions));
  return out;
}

/// What one design gave in one study.
struct Run {
  bool built = false;
  std::vector<double> error_n;  ///< one per point
  int silent = 0;
};

DesignError summary(const Questions& questions, const Design& design, const std::vector<Run>& runs,
                    const PlanSettings& settings, std::size_t points) {
  DesignError out;
  out.design = design;
  out.hours = hoursOf(questions, design, settings.minutes);
  std::vector<double> squares;
  std::vector<double> mean(points, 0);
  double silent = 0;
  for (const auto& run : runs) {
    if (!run.built) continue;
    double square = 0;
    for (std::size_t p = 0; p < points; ++p) {
      square += run.error_n[p] * run.error_n[p] / static_cast<double>(points);
      mean[p] += run.error_n[p];
    }
    squares.push_back(square);
    silent += run.silent;
  }
  const auto built = static_cast<double>(squares.size());
  out.refused = 1 - built / static_cast<double>(runs.size());
  if (squares.empty()) return out;
  double bias = 0;
  for (const double sum : mean) bias += std::pow(sum / built, 2) / static_cast<double>(points);
  out.bias_n = std::sqrt(bias);
  out.silent = silent / built / static_cast<double>(points);
  const double square = base::mean(squares);
  const double half = 1.96 * base::standardDeviation(squares) / std::sqrt(built);
  out.simulated_n = std::sqrt(square);
  out.error_n = out.simulated_n;
  out.low_n = std::sqrt(std::max(0.0, square - half));
  out.high_n = std::sqrt(square + half);
  for (double& one : squares) one = std::sqrt(one);
  out.p95_n = base::quantile(squares, 0.95);
  return out;
}

/// Squared errors that rise from a design to the next one with more nurses are replaced by their mean (pool adjacent
/// violators; Ayer et al. 1955); their intervals move with them.
void pool(std::vector<DesignError>& all, std::size_t first, std::size_t last) {
  struct Block {
    double square;
    std::size_t size;
  };
  std::vector<Block> blocks;
  for (std::size_t i = first; i < last; ++i) {
    blocks.push_back({all[i].simulated_n * all[i].simulated_n, 1});
    while (blocks.size() > 1 && blocks.back().square > blocks[blocks.size() - 2].square) {
      const Block later = blocks.back();
      blocks.pop_back();
      Block& before = blocks.back();
      const auto size = before.size + later.size;
      before.square =
          (before.square * static_cast<double>(before.size) + later.square * static_cast<double>(later.size)) /
          static_cast<double>(size);
      before.size = size;
    }
  }
  std::size_t i = first;
  for (const auto& block : blocks) {
    for (std::size_t k = 0; k < block.size; ++k, ++i) {
      const double moved = std::sqrt(block.square) - all[i].simulated_n;
      all[i].error_n = std::sqrt(block.square);
      all[i].low_n = std::max(0.0, all[i].low_n + moved);
      all[i].high_n += moved;
    }
  }
}

Result<void> check(const Questions& questions, const PlanSettings& settings) {
  const auto items = static_cast<int>(questions.items.size());
  const auto within = [](int value, int low, int high, const std::string& what) -> Result<void> {
    if (value >= low && value <= high) return {};
    return fail(ErrorCode::kValue, what, std::to_string(value), std::to_string(low) + " to " + std::to_string(high));
  };
  if (auto ok = within(settings.least_nurses, 1, kMostNurses, "fewest nurses"); !ok) return ok;
  if (auto ok = within(settings.most_nurses, settings.least_nurses, kMostNurses, "most nurses"); !ok) return ok;
  for (const int one : settings.questions) {
    if (auto ok = within(one, 1, items, "questions"); !ok) return ok;
  }
  for (const int one : settings.strokes) {
    if (auto ok = within(one, 1, 100, "strokes"); !ok) return ok;
  }
  if (settings.questions.empty() || settings.strokes.empty())
    return fail(ErrorCode::kValue, "plan", "no design", "numbers of questions and strokes");
  const auto studies = static_cast<int>(std::min<std::size_t>(settings.studies, kMostStudies + 1));
  if (auto ok = within(studies, 2, kMostStudies, "studies"); !ok) return ok;
  if (settings.population == 0 || settings.points == 0 || settings.threads == 0)
    return fail(ErrorCode::kValue, "plan", "no nurses, points or threads", "at least one of each");
  return {};
}

}  // namespace

double hoursOf(const Questions& asked, const Design& design, const PartMinutes& minutes) {
  const double each = minutes.other +
                      static_cast<double>(asked.speeds()) * (design.strokes + kPractice) * minutes.stroke +
                      static_cast<double>(asked.forces_n.size()) * minutes.force + design.questions * minutes.question;
  return design.nurses * each / 60;
}

const DesignError* StudyPlan::find(const Design& design) const {
  for (const auto& one : designs) {
    if (one.design == design) return &one;
  }
  return nullptr;
}

std::optional<std::size_t> cheapestOf(const StudyPlan& plan, double precision_n) {
  std::optional<std::size_t> out;
  for (std::size_t i = 0; i < plan.designs.size(); ++i) {
    const auto& one = plan.designs[i];
    if (one.refused < 1 && one.high_n <= precision_n && (!out || one.hours < plan.designs[*out].hours)) out = i;
  }
  return out;
}

Result<std::vector<std::vector<double>>> planPoints(const Questions& questions, const std::string& region,
                                                    std::size_t count) {
  const auto& inputs = questions.inputs;
  const std::size_t depth = fuzzy::wayOf(inputs).value();
  std::vector<fuzzy::MembershipFunction> wanted;
  std::vector<std::string> known;
  for (const auto& term : inputs[depth].terms) {
    known.push_back(term.id);
    if (!region.empty() && term.id != region && term.label != region) continue;
    wanted.push_back(fuzzy::MembershipFunction::of(term));
  }
  if (wanted.empty()) {
    std::string list;
    for (const auto& id : known) list += (list.empty() ? "" : ", ") + id;
    return fail(ErrorCode::kValue, "region", base::quoted(region), "one of " + list);
  }
  constexpr std::size_t kBases[] = {2, 3, 5, 7, 11, 13, 17, 19};
  std::vector<std::vector<double>> out;
  for (std::size_t i = 1; out.size() < count; ++i) {
    std::vector<double> point;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const double high =
          fuzzy::roleOf(inputs[k]) == fuzzy::Role::kRate ? std::min(kFastestMmS, inputs[k].max) : inputs[k].max;
      point.push_back(inputs[k].min + (high - inputs[k].min) * halton(i, kBases[k]));
    }
    const bool inside =
        std::any_of(wanted.begin(), wanted.end(), [&](const auto& term) { return term(point[depth]) >= 0.5; });
    if (inside) out.push_back(std::move(point));
  }
  return out;
}

Result<StudyPlan> planStudy(const Questions& questions, const NurseSource& source, const PlanSettings& settings,
                            const std::function<bool(double share)>& go_on) {
  if (auto ok = check(questions, settings); !ok) return tl::unexpected(ok.error());
  StudyPlan out;
  TACTUS_TRY(out.points, planPoints(questions, settings.region, settings.points));
  constexpr double kTruthShare = 0.1;  // of the time, about
  TACTUS_TRY(out.truth_n, truthOf(questions, source, settings, out.points,
                                  [&](double share) { return !go_on || go_on(kTruthShare * share); }));
  std::vector<Design> designs;
  auto by_questions = settings.questions;
  auto by_strokes = settings.strokes;
  std::sort(by_questions.begin(), by_questions.end());
  std::sort(by_strokes.begin(), by_strokes.end());
  for (const int strokes : by_strokes) {
    for (const int asked : by_questions) {
      for (int nurses = settings.least_nurses; nurses <= settings.most_nurses; ++nurses)
        designs.push_back({nurses, asked, strokes});
    }
  }
  std::vector<std::vector<std::size_t>> asked;
  for (const int one : by_questions) asked.push_back(askedOf(questions.items.size(), one));
  std::vector<std::vector<Run>> runs(designs.size(), std::vector<Run>(settings.studies));

  const auto study = [&](std::size_t number) {
    std::size_t at = 0;
    for (const int strokes : by_strokes) {
      const auto people = peopleOf(questions, source, settings, number, settings.most_nurses, strokes);
      if (people.empty()) return;
      std::vector<Result<fuzzy::Variable>> outputs;
      for (int nurses = settings.least_nurses; nurses <= settings.most_nurses; ++nurses)
        outputs.push_back(outputOf(questions, {people.data(), static_cast<std::size_t>(nurses)}, settings.force_terms));
      for (const auto& items : asked) {
        for (const auto& output : outputs) {
          Run& run = runs[at][number];
          const auto nurses = static_cast<std::size_t>(designs[at].nurses);
          ++at;
          if (!output) continue;
          const auto model = modelOf(questions, {people.data(), nurses}, items, *output);
          run.built = forcesOf(model, out.points, run.error_n, run.silent);
          for (std::size_t p = 0; p < run.error_n.size(); ++p) run.error_n[p] -= out.truth_n[p];
        }
      }
    }
  };
  if (!base::inParallel(settings.studies, settings.threads, study,
                        [&](double share) { return !go_on || go_on(kTruthShare + (1 - kTruthShare) * share); }))
    return fail(ErrorCode::kCancelled, "plan", "canceled", "the whole run");

  for (std::size_t i = 0; i < designs.size(); ++i)
    out.designs.push_back(summary(questions, designs[i], runs[i], settings, out.points.size()));
  const auto row = static_cast<std::size_t>(settings.most_nurses - settings.least_nurses + 1);
  for (std::size_t first = 0; first < designs.size(); first += row) pool(out.designs, first, first + row);
  out.cheapest = cheapestOf(out, settings.precision_n);
  return out;
}

}  // namespace tactus::planning
