#include "tests/bench/workbench_stages.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>

#include "app/editing/membership_edits.h"
#include "app/figures/force_curves.h"
#include "app/workbench/understand/map/force_map.h"
#include "core/analysis/explain.h"
#include "core/base/check.h"
#include "core/fuzzy/scene.h"

#include "tests/bench/cases.h"
#include "tests/bench/text_table.h"

namespace tactus::bench {
namespace {

constexpr std::array kExperts = {1, 4, 32, 256};
constexpr std::size_t kDepth = 2;
constexpr std::size_t kSpeed = 3;
constexpr std::size_t kSide = workbench::ForceMapController::kSides.back();
constexpr std::array<double, 4> kPoint = {kFixedLubrication, kFixedNeckFlexionDeg, 110, 100};

double medianUs(int rounds, const std::function<void()>& work) {
  std::vector<double> all;
  for (int i = 0; i <= rounds; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::micro> passed = std::chrono::steady_clock::now() - start;
    if (i > 0) all.push_back(passed.count());
  }
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
  return all[all.size() / 2];
}

// As the map's controller computes it: the scene, then row by row.
workbench::ForceMap mapOf(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled) {
  auto scene = fuzzy::Scene::specialize(compiled, sceneOfNgt());
  TACTUS_CHECK(scene.has_value());
  workbench::ForceMap map{
      kDepth, kSpeed, {}, {}, kSide, std::vector<double>(kSide * kSide), std::vector<std::uint8_t>(kSide * kSide)};
  const auto places = [](const fuzzy::Variable& input) {
    std::vector<double> out(kSide);
    for (std::size_t i = 0; i < kSide; ++i) {
      out[i] = std::lerp(input.min, input.max, static_cast<double>(i) / static_cast<double>(kSide - 1));
    }
    return out;
  };
  const std::vector<double> depths = places(model.inputs[kDepth]);
  const std::vector<double> speeds = places(model.inputs[kSpeed]);
  for (std::size_t y = 0; y < kSide; ++y) {
    const std::vector<double> speed(kSide, speeds[y]);
    const std::array<std::span<const double>, 2> inputs = {depths, speed};
    scene->evaluateBatch(
        inputs, {std::span(map.force_n).subspan(y * kSide, kSide), std::span(map.fired).subspan(y * kSide, kSide)});
  }
  return map;
}

}  // namespace

std::vector<std::vector<std::string>> stageTimes(int rounds) {
  std::vector<std::vector<std::string>> rows = {
      {"experts", "edit", "compile", "curves", "points of a curve", "map", "contours", "explanation"}};
  for (const int experts : kExperts) {
    const fuzzy::ForceModel model = syntheticExperts(experts);
    const fuzzy::CompiledModel compiled = *fuzzy::compile(model);
    const editing::VertexPlace vertex{{"depth", {}}, model.inputs[kDepth].terms[1].id, 3};
    const double from = model.inputs[kDepth].terms[1].points[3];
    const int turns = std::max(5, rounds / experts);
    const double edit =
        medianUs(turns, [&] { TACTUS_CHECK(editing::moveVertex(model, vertex, from + 3, {}).has_value()); });
    const double compile = medianUs(turns, [&] { TACTUS_CHECK(fuzzy::compile(model).has_value()); });
    figures::ForceCurves curves;
    const double curve = medianUs(turns, [&] { curves = figures::computeCurves(model, compiled, kDepth, kPoint); });
    workbench::ForceMap map;
    const double surface = medianUs(turns, [&] { map = mapOf(model, compiled); });
    const std::vector<double> levels = workbench::contourLevels(model.output.min, model.output.max);
    std::vector<std::vector<QLineF>> lines;
    const double contours = medianUs(turns, [&] { lines = workbench::contourLines(map, levels); });
    const double explanation =
        medianUs(turns, [&] { TACTUS_CHECK(analysis::explain(model, compiled, kPoint).has_value()); });
    std::vector<std::string> row = {std::to_string(experts)};
    for (const double us : {edit, compile, curve}) row.push_back(threeDigits(us / 1000));
    row.push_back(std::to_string(curves.x.size()));
    for (const double us : {surface, contours, explanation}) row.push_back(threeDigits(us / 1000));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::vector<std::string>> stageDifferences() {
  std::vector<std::vector<std::string>> rows = {
      {"experts", "curve of the mean, N", "curves of the experts, N", "map, N", "places"}};
  for (const int experts : kExperts) {
    const fuzzy::ForceModel model = syntheticExperts(experts);
    const fuzzy::CompiledModel compiled = *fuzzy::compile(model);
    const figures::ForceCurves curves = figures::computeCurves(model, compiled, kDepth, kPoint);
    const workbench::ForceMap map = mapOf(model, compiled);
    double of_mean = 0;
    double of_experts = 0;
    double of_map = 0;
    std::array<double, 4> point = kPoint;
    for (std::size_t i = 0; i < curves.x.size(); ++i) {
      point[kDepth] = curves.x[i];
      of_mean = std::max(of_mean, std::abs(curves.mean[i].force_n - compiled.evaluate(point).force_n));
      for (std::size_t e = 0; e < curves.experts.size(); ++e) {
        of_experts =
            std::max(of_experts, std::abs(curves.experts[e][i].force_n - compiled.evaluateExpert(e, point).force_n));
      }
    }
    std::size_t places = 0;
    for (std::size_t y = 0; y < kSide; y += 10) {
      for (std::size_t x = 0; x < kSide; ++x, ++places) {
        const double n = static_cast<double>(kSide - 1);
        point[kDepth] = std::lerp(model.inputs[kDepth].min, model.inputs[kDepth].max, static_cast<double>(x) / n);
        point[kSpeed] = std::lerp(model.inputs[kSpeed].min, model.inputs[kSpeed].max, static_cast<double>(y) / n);
        of_map = std::max(of_map, std::abs(map.force(x, y) - compiled.evaluate(point).force_n));
      }
    }
    rows.push_back({std::to_string(experts), threeDigits(of_mean), threeDigits(of_experts), threeDigits(of_map),
                    std::to_string(curves.x.size()) + " + " + std::to_string(places)});
  }
  return rows;
}

}  // namespace tactus::bench
