// Force over two inputs while the other inputs stay fixed: the numbers behind the color map and the surface.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/model/open_model.h"
#include "core/fuzzy/scene.h"

namespace tactus::workbench {

class SceneController;
struct FigurePreset;

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

/// Computes the map of a scene once for all views, in slices so that the window stays responsive. It starts with coarse
/// maps, unless a finer one is ready within the first slice. A new request replaces an older one. Of an input that is
/// zoomed only the part that is shown is computed, as finely as otherwise the whole.
class ForceMapController : public QObject {
  Q_OBJECT

 public:
  static constexpr std::array<std::size_t, 4> kSides = {26, 51, 101, 201};  ///< each has all points of the one before
  static constexpr int kSliceMs = 6;                                        ///< less than half a frame at 60 Hz

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
  /// Brings the map up to date with the scene: computes the first slice now, the others from the event loop. Returns at
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
  void applyPreset(const FigurePreset& preset);
  void dropPoint(std::size_t input);
  void dropPart(const std::string& input_id);
  void compute();
  void stop();
  void work();
  std::size_t firstLevel() const;
  void beginLevel();
  void computeRow();

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

  // The request in progress.
  std::shared_ptr<const OpenModel> model_;
  std::optional<fuzzy::Scene> order_;
  std::vector<double> point_;
  figures::Interval x_part_;
  figures::Interval y_part_;
  std::size_t level_ = kSides.size();  ///< index in kSides; past the end if none is in progress
  std::size_t row_ = 0;
  double place_ns_ = 0;  ///< time of one point in the last map; 0 before the first map
  ForceMap growing_;
  std::vector<double> xs_;
  std::vector<double> ys_;
  QTimer slices_{this};
};

}  // namespace tactus::workbench
