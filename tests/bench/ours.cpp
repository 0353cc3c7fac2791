// Our own evaluators as contenders.
#include <memory>

#include "core/base/check.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/model_tables.h"
#include "core/fuzzy/scene.h"

#include "tests/bench/contenders.h"

namespace tactus::bench {
namespace {

using Columns = std::vector<std::span<const double>>;

Columns stretchOf(const Columns& columns, std::size_t first, std::size_t count) {
  Columns out;
  for (const auto& column : columns) out.push_back(column.subspan(first, count));
  return out;
}

fuzzy::Scene sceneOf(const Case& about) {
  auto scene = fuzzy::Scene::specialize(about.compiled, about.fixed);
  TACTUS_CHECK(scene.has_value());
  return std::move(*scene);
}

/// The columns of the inputs that vary.
Columns freeColumns(const Case& about) {
  Columns out;
  for (std::size_t i = 0; i < about.fixed.size(); ++i) {
    if (!about.fixed[i]) out.emplace_back(about.points.columns[i]);
  }
  return out;
}

}  // namespace

Contender onePoint(const Case& about) {
  return {"exact, one point",
          0,
          &about,
          {about.name + ": exact, one point", about.points.count(), [&about](std::size_t first, std::span<double> out) {
             for (std::size_t i = 0; i < out.size(); ++i)
               out[i] = about.compiled.evaluate(about.points.row(first + i)).force_n;
           }}};
}

Contender onePoint(const Case& about, const fuzzy::Kernels& kernels) {
  const std::string set = kernels.name == "sse2" ? "x86-64" : std::string(kernels.name);
  const std::string family = "exact, one point, " + set;
  return {family,
          0,
          &about,
          {about.name + ": " + family, about.points.count(), [&](std::size_t first, std::span<double> out) {
             for (std::size_t i = 0; i < out.size(); ++i) {
               out[i] = fuzzy::evaluatePoint(about.compiled.tables(), kernels, about.points.row(first + i)).force_n;
             }
           }}};
}

Contender batch(const Case& about) {
  const Columns all(about.points.columns.begin(), about.points.columns.end());
  auto run = [&about, all, fired = std::vector<std::uint8_t>(about.points.count())](std::size_t first,
                                                                                    std::span<double> out) mutable {
    fuzzy::evaluateBatch(about.compiled, stretchOf(all, first, out.size()), {out, {fired.data(), out.size()}});
  };
  return {"exact, batch", 0, &about, {about.name + ": exact, batch", about.points.count(), run}};
}

Contender sceneOnePoint(const Case& about) {
  std::vector<double> rows;
  const Columns columns = freeColumns(about);
  for (std::size_t p = 0; p < about.points.count(); ++p) {
    for (const auto& column : columns) rows.push_back(column[p]);
  }
  auto run = [scene = sceneOf(about), rows, width = columns.size()](std::size_t first, std::span<double> out) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = scene.evaluate({rows.data() + (first + i) * width, width}).force_n;
    }
  };
  return {"exact, scene, one point", 0, &about, {about.name + ": exact, scene, one point", about.points.count(), run}};
}

Contender sceneBatch(const Case& about) {
  auto run = [scene = sceneOf(about), all = freeColumns(about),
              fired = std::vector<std::uint8_t>(about.points.count())](std::size_t first,
                                                                       std::span<double> out) mutable {
    scene.evaluateBatch(stretchOf(all, first, out.size()), {out, {fired.data(), out.size()}});
  };
  return {"exact, scene, batch", 0, &about, {about.name + ": exact, scene, batch", about.points.count(), run}};
}

}  // namespace tactus::bench
