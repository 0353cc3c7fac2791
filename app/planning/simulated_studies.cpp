#include "app/planning/simulated_studies.h"

#include <numeric>

#include "core/base/in_parallel.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::planning {

using base::ErrorCode;
using base::fail;
using base::Result;

std::uint64_t seedOf(std::uint64_t seed, std::uint64_t number) {
  std::uint64_t z = seed * 0xd1342543de82ef95U + (number + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

std::vector<NurseData> peopleOf(const Questions& questions, const NurseSource& source, const PlanSettings& settings,
                                std::uint64_t number, int nurses, int strokes) {
  base::Random random(seedOf(settings.seed, 2 * number + 1));
  std::vector<NurseData> out;
  for (int who = 0; who < nurses; ++who) {
    const auto nurse = source(random);
    base::Random noise(random.next());  // the numbers of strokes do not move the next nurse
    auto data = dataOf(questions, nurse, settings.noise, strokes, "N" + std::to_string(who + 1), noise);
    if (!data) return {};
    out.push_back(std::move(*data));
  }
  return out;
}

bool forcesOf(const fuzzy::ForceModel& model, const std::vector<std::vector<double>>& points, std::vector<double>& out,
              int& silent) {
  const auto compiled = fuzzy::compile(model);
  if (!compiled) return false;
  out.clear();
  for (const auto& point : points) {
    const auto force = compiled->evaluate(point);
    out.push_back(force.force_n);
    silent += force.fired ? 0 : 1;
  }
  return true;
}

Result<std::vector<double>> truthOf(const Questions& questions, const NurseSource& source, const PlanSettings& settings,
                                    const std::vector<std::vector<double>>& points,
                                    const std::function<bool(double)>& go_on) {
  std::vector<std::size_t> all(questions.items.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::vector<double>> forces(settings.population);
  const auto one = [&](std::size_t who) {
    base::Random random(seedOf(settings.seed, 2 * who));
    const auto data = trueDataOf(questions, source(random));
    if (!data) return;
    const auto output = outputOf(questions, {&*data, 1}, settings.force_terms);
    if (!output) return;
    int silent = 0;
    if (!forcesOf(modelOf(questions, {&*data, 1}, all, *output), points, forces[who], silent)) forces[who].clear();
  };
  if (!base::inParallel(settings.population, settings.threads, one, go_on))
    return fail(ErrorCode::kCancelled, "simulated studies", "canceled", "the whole run");
  std::vector<double> truth(points.size(), 0);
  double count = 0;
  for (const auto& own : forces) {
    if (own.empty()) continue;
    ++count;
    for (std::size_t p = 0; p < truth.size(); ++p) truth[p] += own[p];
  }
  if (count == 0)
    return fail(ErrorCode::kData, "simulated studies", "no nurse with a model", "nurses who use the words");
  for (double& mean : truth) mean /= count;
  return truth;
}

}  // namespace tactus::planning
