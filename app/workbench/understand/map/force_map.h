// Keeps the force map of the scene up to date for all views: what of it is computed, when, and on which thread.
#pragma once

#include <QLineF>
#include <QObject>
#include <QString>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/base/worker.h"
#include "app/workbench/model/open_model.h"
#include "core/fuzzy/scene.h"

namespace tactus::workbench {

class SceneController;

// Force over two inputs while the other inputs stay fixed: the numbers behind the color map and the surface, and the
// request to compute them, which any thread can serve.

/// Forces on a grid over the parts of two inputs that are shown, including the ends.
struct ForceMap {
  std::size_t x_input = 0;
  std::size_t y_input = 0;
  figures::Interval x_part;  ///< of the universe
  figures::Interval y_part;
  std::size_t side = 0;             ///< points along each input
  std::vector<double> force_n;      ///< side * side values, row by row from the lowest y
  std::vector<std::uint8_t> fired;  ///< 1 if a rule fires

  double force(std::size_t x, std::size_t y) const { return force_n[y * side + x]; }
  bool isFired(std::size_t x, std::size_t y) const { return fired[y * side + x] != 0; }
};

/// What a map is computed of. Immutable; it shares the model.
class MapRequest {
 public:
  struct Axis {
    std::size_t input = 0;
    figures::Interval part;  ///< of its universe
  };

  /// `point`: one value per input; those of the axes do not matter. `expert`: nothing for the mean.
  MapRequest(std::shared_ptr<const OpenModel> model, std::vector<double> point, const Axis& x, const Axis& y,
             std::optional<std::size_t> expert);

  /// A map of `side` places along each input, at least 2, without forces.
  ForceMap begin(std::size_t side) const;
  /// Computes rows of `map` while `goes_on` says so, which is asked before each row. Returns the number of rows that
  /// are computed.
  /// Thread: any.
  std::size_t compute(ForceMap& map, const std::function<bool()>& goes_on) const;
  /// How many forces stand behind one place: that of the expert, or the mean and those of all experts.
  std::size_t forcesOfAPlace() const;

 private:
  std::shared_ptr<const OpenModel> model_;
  std::vector<double> point_;
  Axis x_;
  Axis y_;
  std::optional<std::size_t> expert_;
  std::optional<fuzzy::Scene> scene_;  ///< of the mean
};

/// Computes the map of a scene once for all views. As fine a map as a slice of a frame has time for is computed at
/// once, so that an edit shows it in its frame; finer ones, of models with many experts, on another thread, and they
/// follow. A new request replaces an older one. Of an input that is zoomed only the part that is shown is computed, as
/// finely as otherwise the whole.
class ForceMapController : public QObject {
  Q_OBJECT

 public:
  static constexpr std::array<std::size_t, 4> kSides = {26, 51, 101, 201};  ///< each has all points of the one before
  static constexpr int kSliceMs = 6;   ///< of the window's thread: less than half a frame at 60 Hz
  static constexpr int kStepMs = 100;  ///< of the other thread: after this time at the latest a finer map should follow

  explicit ForceMapController(const SceneController& scene, QObject* parent = nullptr);

  std::size_t xInput() const { return x_input_; }
  std::size_t yInput() const { return y_input_; }
  /// The expert of the map; nothing: the mean.
  std::optional<std::size_t> expert() const { return expert_; }

  /// The newest finished map; null before the first one.
  const ForceMap* map() const { return map_ ? &*map_ : nullptr; }
  /// Whether the finest map is finished.
  bool isFinest() const { return level_ == kSides.size(); }
  /// The force of the map's expert, or of the mean, at the operating point.
  const fuzzy::Evaluation& forceAtPoint() const;
  /// The operating point on the axes and its force, as the label shows it: `300 mm, 50 mm/s   0.545 N`.
  QString pointText() const;

  /// A view of the map became visible. Without a visible view nothing is computed.
  void addViewer() { ++viewers_; }
  /// A view was hidden. Unfinished work waits for the next `update`.
  void removeViewer();

 public slots:
  /// Chooses the axes. Choosing the other axis's input swaps the two. Axes and expert stay chosen if another model has
  /// them, too.
  void setAxes(std::size_t x_input, std::size_t y_input);
  void setExpert(std::optional<std::size_t> expert);
  /// Brings the map up to date with the scene: computes the first map now, finer ones on another thread. Returns at
  /// once if the map is current or in progress.
  void update();
  /// The same, but finishes the map now: some milliseconds for a few experts. For files and pictures, which need the
  /// whole map.
  void finish();

 signals:
  /// The axes or the expert changed; the map is not computed yet.
  void choiceChanged();
  /// A map is ready: the first of a request, or a finer one.
  void mapChanged();

 private:
  void adoptModel();
  void applyFigure(const procedure::Figure& figure);
  void dropPoint(std::size_t input);
  void dropPart(const std::string& input_id);
  void stop();
  std::optional<std::size_t> finestWithin(double ms) const;
  bool computeNow(std::size_t level, const std::function<bool()>& goes_on);
  void computeBehind();
  void setMap(ForceMap map, std::size_t level, double cpu_ns);

  const SceneController& scene_;
  std::size_t x_input_ = 0;
  std::size_t y_input_ = 0;
  std::optional<std::size_t> expert_;
  /// The same as ids, which stay valid for another model; empty: nothing was chosen.
  std::string x_id_;
  std::string y_id_;
  std::string expert_id_;
  std::optional<ForceMap> map_;
  mutable std::optional<fuzzy::Evaluation> here_;  ///< at the operating point; computed on demand
  int viewers_ = 0;
  bool stale_ = true;  ///< the map is neither current nor in progress

  std::shared_ptr<const MapRequest> request_;  ///< the newest one
  std::size_t level_ = kSides.size();          ///< index in kSides of the next map; past the end if none is to come
  double place_ns_ = 0;                        ///< time of one place on a processor; 0 before the first map of a model
  Background worker_;
};

// Lines of equal force through a map.

/// The contour lines at the force `level_n`, as pieces in grid units: x and y from 0 to side - 1. Each piece is
/// straight within one cell. A cell with a corner where no rule fires has none. Method: marching squares (Lorensen and
/// Cline 1987, in two dimensions); a saddle is cut by the mean of its corners.
std::vector<QLineF> contourLines(const ForceMap& map, double level_n);
/// The same for several ascending levels in one pass over the map: a list of pieces for each level.
std::vector<std::vector<QLineF>> contourLines(const ForceMap& map, std::span<const double> levels_n);

/// The levels for a universe: about ten round numbers, without its ends.
std::vector<double> contourLevels(double min_n, double max_n);

// A force map as a table, for every panel that shows it.

/// The finest map of the current scene, computed now: one row for every point, x first; the force is empty if no rule
/// fires. The caption names the axes and the expert. A model with two inputs or more must be open.
PlotTable mapTable(const SceneController& scene, ForceMapController& map, const QString& suffix);

}  // namespace tactus::workbench
