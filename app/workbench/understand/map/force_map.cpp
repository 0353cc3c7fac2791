#include "app/workbench/understand/map/force_map.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <span>
#include <utility>
#include <vector>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_ranges.h"
#include "app/workbench/plot/plot_caption.h"
#include "core/base/check.h"

namespace tactus::workbench {
namespace {

struct MapTable {
  Q_DECLARE_TR_FUNCTIONS(MapTable)
};

}  // namespace

PlotTable mapTable(const SceneController& scene, ForceMapController& controller, const QString& suffix) {
  const fuzzy::ForceModel& model = scene.model()->model;
  const fuzzy::Variable& x = model.inputs[controller.xInput()];
  const fuzzy::Variable& y = model.inputs[controller.yInput()];
  const fuzzy::Expert* expert = controller.expert() ? &model.experts[*controller.expert()] : nullptr;
  controller.finish();
  const ForceMap& map = *controller.map();

  const std::size_t axes[] = {controller.xInput(), controller.yInput()};
  const QString what = MapTable::tr("%1 over %2 and %3").arg(labelOf(model.output), labelOf(x), labelOf(y));
  const QString whose = expert ? MapTable::tr("expert %1").arg(labelOf(*expert)) : MapTable::tr("mean of the experts");
  PlotTable table = captionedTable(scene, QStringLiteral("%1, %2").arg(what, whose), axes, {}, suffix);
  table.columns = {columnName(x), columnName(y), expert ? columnName(model.output, *expert) : columnName(model.output)};
  const auto place = [&map](const figures::Interval& part, std::size_t i) {
    return std::lerp(part.low, part.high, static_cast<double>(i) / static_cast<double>(map.side - 1));
  };
  for (std::size_t row = 0; row < map.side; ++row) {
    for (std::size_t column = 0; column < map.side; ++column) {
      table.rows.push_back({place(map.x_part, column), place(map.y_part, row),
                            forceCell({map.force(column, row), map.isFired(column, row)})});
    }
  }
  return table;
}

namespace {

// A cell of the grid: forces at its corners, around the cell, so that neighbors in the list share an edge.
struct Cell {
  std::array<QPointF, 4> places;
  std::array<double, 4> force_n{};
};

void addPieces(const Cell& cell, double level_n, std::vector<QLineF>& lines) {
  std::array<QPointF, 4> points;
  std::size_t count = 0;
  double middle = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    const double here = cell.force_n[i] - level_n;
    const double there = cell.force_n[next] - level_n;
    middle += here / 4;
    if ((here > 0) == (there > 0)) continue;
    points[count++] = cell.places[i] + (cell.places[next] - cell.places[i]) * (here / (here - there));
  }
  if (count == 2) {
    lines.emplace_back(points[0], points[1]);
  } else if (count == 4) {
    // The edges are crossed in order; corner 0 stands alone where it differs from the middle.
    const bool first_alone = (cell.force_n[0] - level_n > 0) != (middle > 0);
    lines.emplace_back(points[0], points[first_alone ? 3 : 1]);
    lines.emplace_back(points[2], points[first_alone ? 1 : 3]);
  }
}

}  // namespace

std::vector<std::vector<QLineF>> contourLines(const ForceMap& map, std::span<const double> levels_n) {
  std::vector<std::vector<QLineF>> lines(levels_n.size());
  const std::size_t side = map.side;
  for (std::size_t y = 0; y + 1 < side; ++y) {
    const double* const below = map.force_n.data() + y * side;
    const double* const above = below + side;
    for (std::size_t x = 0; x + 1 < side; ++x) {
      // Most cells lie between two levels.
      const auto [low, high] = std::minmax({below[x], below[x + 1], above[x + 1], above[x]});
      auto level = std::lower_bound(levels_n.begin(), levels_n.end(), low);
      if (level == levels_n.end() || *level >= high) continue;
      if (!map.isFired(x, y) || !map.isFired(x + 1, y) || !map.isFired(x + 1, y + 1) || !map.isFired(x, y + 1)) {
        continue;
      }
      const auto left = static_cast<double>(x);
      const auto bottom = static_cast<double>(y);
      const Cell cell{{QPointF(left, bottom), {left + 1, bottom}, {left + 1, bottom + 1}, {left, bottom + 1}},
                      {below[x], below[x + 1], above[x + 1], above[x]}};
      for (; level != levels_n.end() && *level < high; ++level) {
        addPieces(cell, *level, lines[static_cast<std::size_t>(level - levels_n.begin())]);
      }
    }
  }
  return lines;
}

std::vector<QLineF> contourLines(const ForceMap& map, double level_n) {
  return std::move(contourLines(map, std::span(&level_n, 1)).front());
}

std::vector<double> contourLevels(double min_n, double max_n) {
  const double rough = (max_n - min_n) / 10;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = power;
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    step = factor * power;
    if (step >= rough * 0.8) break;
  }
  std::vector<double> levels;
  const auto first = static_cast<long long>(std::floor(min_n / step)) + 1;
  for (long long i = first; static_cast<double>(i) * step < max_n - step * 1e-9; ++i) {
    levels.push_back(static_cast<double>(i) * step);
  }
  return levels;
}

namespace {

std::vector<double> evenly(const figures::Interval& part, std::size_t count) {
  std::vector<double> places(count);
  for (std::size_t i = 0; i < count; ++i) {
    places[i] = std::lerp(part.low, part.high, static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return places;
}

}  // namespace

MapRequest::MapRequest(std::shared_ptr<const OpenModel> model, std::vector<double> point, const Axis& x, const Axis& y,
                       std::optional<std::size_t> expert)
    : model_(std::move(model)), point_(std::move(point)), x_(x), y_(y), expert_(expert) {
  TACTUS_CHECK(x_.input != y_.input);
  if (expert_) return;
  std::vector<std::optional<double>> fixed(point_.begin(), point_.end());
  fixed[x_.input].reset();
  fixed[y_.input].reset();
  auto scene = fuzzy::Scene::specialize(model_->compiled, fixed);
  TACTUS_CHECK(scene.has_value());
  scene_ = std::move(*scene);
}

ForceMap MapRequest::begin(std::size_t side) const {
  return {x_.input,
          y_.input,
          x_.part,
          y_.part,
          side,
          std::vector<double>(side * side),
          std::vector<std::uint8_t>(side * side)};
}

std::size_t MapRequest::compute(ForceMap& map, const std::function<bool()>& goes_on) const {
  const std::vector<double> xs = evenly(x_.part, map.side);
  const std::vector<double> ys = evenly(y_.part, map.side);
  std::vector<double> same_y(map.side);
  std::vector<double> point = point_;
  std::size_t row = 0;
  for (; row < map.side && goes_on(); ++row) {
    const std::span<double> forces = std::span(map.force_n).subspan(row * map.side, map.side);
    const std::span<std::uint8_t> fired = std::span(map.fired).subspan(row * map.side, map.side);
    if (expert_) {
      point[y_.input] = ys[row];
      for (std::size_t i = 0; i < map.side; ++i) {
        point[x_.input] = xs[i];
        const fuzzy::Evaluation here = model_->compiled.evaluateExpert(*expert_, point);
        forces[i] = here.force_n;
        fired[i] = here.fired ? 1 : 0;
      }
      continue;
    }
    std::fill(same_y.begin(), same_y.end(), ys[row]);
    // The varying inputs stand in the order of the model.
    std::array<std::span<const double>, 2> inputs = {xs, same_y};
    if (y_.input < x_.input) std::swap(inputs[0], inputs[1]);
    scene_->evaluateBatch(inputs, {forces, fired});
  }
  return row;
}

std::size_t MapRequest::forcesOfAPlace() const { return expert_ ? 1 : 1 + model_->compiled.expertCount(); }

namespace {

constexpr double kNsPerMs = 1e6;

// What else runs on the machine does not count.
double threadCpuNs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

}  // namespace

ForceMapController::ForceMapController(const SceneController& scene, QObject* parent) : QObject(parent), scene_(scene) {
  connect(&scene_, &SceneController::modelChanged, this, &ForceMapController::adoptModel);
  connect(&scene_, &SceneController::modelEdited, this, [this] {
    stale_ = true;
    here_.reset();
  });
  connect(&scene_, &SceneController::valueChanged, this, &ForceMapController::dropPoint);
  connect(&scene_.ranges(), &ShownRanges::changed, this, &ForceMapController::dropPart);
  connect(&scene_, &SceneController::figureApplied, this, &ForceMapController::applyFigure);
  if (scene_.model()) adoptModel();
}

const fuzzy::Evaluation& ForceMapController::forceAtPoint() const {
  if (here_) return *here_;
  const OpenModel& open = *scene_.model();
  std::vector<double> point;
  for (std::size_t i = 0; i < open.model.inputs.size(); ++i) point.push_back(scene_.value(i));
  scene_.countEvaluations(1);
  here_ = expert_ ? open.compiled.evaluateExpert(*expert_, point) : open.compiled.evaluate(point);
  return *here_;
}

QString ForceMapController::pointText() const {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const fuzzy::Variable& x = model.inputs[x_input_];
  const fuzzy::Variable& y = model.inputs[y_input_];
  const fuzzy::Evaluation& here = forceAtPoint();
  return QStringLiteral("%1, %2   %3")
      .arg(placeText(x, scene_.value(x_input_)), placeText(y, scene_.value(y_input_)),
           here.fired ? forceText(here.force_n, model.output.unit) : tr("no rule fires"));
}

void ForceMapController::removeViewer() {
  TACTUS_CHECK(viewers_ > 0);
  if (--viewers_ > 0 || isFinest()) return;
  stop();
  stale_ = true;
}

void ForceMapController::setAxes(std::size_t x_input, std::size_t y_input) {
  if (x_input == y_input) {
    // The input that was chosen a second time leaves its old axis to the other one.
    if (x_input == x_input_) {
      x_input = y_input_;
    } else {
      y_input = x_input_;
    }
  }
  if (x_input == x_input_ && y_input == y_input_) return;
  stop();
  x_input_ = x_input;
  y_input_ = y_input;
  x_id_ = scene_.model()->model.inputs[x_input].id;
  y_id_ = scene_.model()->model.inputs[y_input].id;
  map_.reset();
  stale_ = true;
  emit choiceChanged();
}

void ForceMapController::setExpert(std::optional<std::size_t> expert) {
  if (expert == expert_) return;
  stop();
  place_ns_ = 0;
  expert_ = expert;
  expert_id_ = expert ? scene_.model()->model.experts[*expert].id : std::string();
  map_.reset();
  here_.reset();
  stale_ = true;
  emit choiceChanged();
}

void ForceMapController::applyFigure(const procedure::Figure& figure) {
  if (figure.map.empty()) return;
  const auto x = inputNamed(scene_.model()->model, figure.map[0]);
  const auto y = inputNamed(scene_.model()->model, figure.map[1]);
  if (!x || !y) return;
  setExpert(std::nullopt);
  setAxes(*x, *y);
}

void ForceMapController::update() {
  if (!stale_ || !scene_.model() || x_input_ == y_input_) return;
  stale_ = false;
  stop();
  const std::vector<fuzzy::Variable>& inputs = scene_.model()->model.inputs;
  const auto axis = [&](std::size_t input) { return MapRequest::Axis{input, scene_.ranges().of(inputs[input])}; };
  request_ =
      std::make_shared<const MapRequest>(scene_.shared(), scene_.values(), axis(x_input_), axis(y_input_), expert_);
  level_ = 0;
  const double until_ns = threadCpuNs() + kSliceMs * kNsPerMs;
  const auto in_slice = [until_ns] { return threadCpuNs() < until_ns; };
  bool computed = false;
  if (place_ns_ == 0) computed = computeNow(0, in_slice);
  // Only what will be finished is begun.
  const double rest_ms = (until_ns - threadCpuNs()) / kNsPerMs;
  if (const auto level = finestWithin(rest_ms); level && *level >= level_) {
    computed = computeNow(*level, [] { return true; }) || computed;
  }
  if (!isFinest()) computeBehind();
  if (computed) emit mapChanged();
}

void ForceMapController::dropPoint(std::size_t input) {
  here_.reset();
  if (input != x_input_ && input != y_input_) stale_ = true;
}

void ForceMapController::dropPart(const std::string& input_id) {
  if (!scene_.model()) return;
  const std::vector<fuzzy::Variable>& inputs = scene_.model()->model.inputs;
  if (input_id == inputs[x_input_].id || input_id == inputs[y_input_].id) stale_ = true;
}

void ForceMapController::finish() {
  update();
  if (isFinest()) return;
  worker_.drop();
  computeNow(kSides.size() - 1, [] { return true; });
  emit mapChanged();
}

std::optional<std::size_t> ForceMapController::finestWithin(double ms) const {
  std::optional<std::size_t> level;
  if (place_ns_ == 0) return level;
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    if (static_cast<double>(kSides[i] * kSides[i]) * place_ns_ <= ms * kNsPerMs) level = i;
  }
  return level;
}

bool ForceMapController::computeNow(std::size_t level, const std::function<bool()>& goes_on) {
  const double begun_ns = threadCpuNs();
  ForceMap map = request_->begin(kSides[level]);
  if (request_->compute(map, goes_on) < map.side) return false;
  setMap(std::move(map), level, threadCpuNs() - begun_ns);
  return true;
}

void ForceMapController::computeBehind() {
  const std::size_t level = std::max(level_, finestWithin(kStepMs).value_or(0));
  worker_.run([this, level, request = request_](const std::stop_token& stop) -> Background::Deliver {
    const double begun_ns = threadCpuNs();
    auto map = std::make_shared<ForceMap>(request->begin(kSides[level]));
    if (request->compute(*map, [&stop] { return !stop.stop_requested(); }) < map->side) return {};
    const double cpu_ns = threadCpuNs() - begun_ns;
    return [this, level, cpu_ns, map = std::move(map)] {
      setMap(std::move(*map), level, cpu_ns);
      if (!isFinest()) computeBehind();
      emit mapChanged();
    };
  });
}

void ForceMapController::setMap(ForceMap map, std::size_t level, double cpu_ns) {
  const std::size_t places = map.side * map.side;
  place_ns_ = cpu_ns / static_cast<double>(places);
  scene_.countEvaluations(places * request_->forcesOfAPlace());
  map_ = std::move(map);
  level_ = level + 1;
}

void ForceMapController::stop() {
  worker_.drop();
  level_ = kSides.size();
}

void ForceMapController::adoptModel() {
  stop();
  place_ns_ = 0;
  map_.reset();
  here_.reset();
  stale_ = true;
  const fuzzy::ForceModel& model = scene_.model()->model;
  const auto x_chosen = inputNamed(model, x_id_);
  const auto y_chosen = inputNamed(model, y_id_);
  if (x_chosen && y_chosen) {
    x_input_ = *x_chosen;
    y_input_ = *y_chosen;
  } else {
    // Depth and speed as in Fig. 9 of the paper. A model with one input has no map.
    x_input_ = fuzzy::wayOf(model.inputs).value_or(model.inputs.size() - 1);
    y_input_ = fuzzy::rateOf(model.inputs).value_or(0);
    if (x_input_ == y_input_) y_input_ = x_input_ == 0 ? model.inputs.size() - 1 : 0;
  }
  expert_ = expertNamed(model, expert_id_);
  emit choiceChanged();
}

}  // namespace tactus::workbench
