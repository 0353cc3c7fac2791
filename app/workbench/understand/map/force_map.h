// Force over two inputs while the others stay: the numbers behind the color map and the surface, from coarse to fine.
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

#include "app/workbench/model/open_model.h"
#include "core/fuzzy/scene.h"

namespace tactus::workbench {

class SceneController;
struct FigurePreset;

/// Forces on a grid over the universes of two inputs, ends included.
struct ForceMap {
  std::size_t x_input = 0;
  std::size_t y_input = 0;
  std::size_t side = 0;             ///< places along each input
  std::vector<double> force_n;      ///< side * side, row by row from the lowest y
  std::vector<std::uint8_t> fired;  ///< 1 where a rule fires

  double force(std::size_t x, std::size_t y) const { return force_n[y * side + x]; }
  bool isFired(std::size_t x, std::size_t y) const { return fired[y * side + x] != 0; }
};

/// Computes the map of a scene in slices that leave the window alive, once for all views that show it: coarse maps
/// first, unless a finer one is there within the first slice. A newer order takes the place of an older one.
class ForceMapController : public QObject {
  Q_OBJECT

 public:
  static constexpr std::array<std::size_t, 4> kSides = {26, 51, 101, 201};  ///< each has the places of the one before
  static constexpr int kSliceMs = 6;                                        ///< less than half a frame at 60 Hz

  explicit ForceMapController(const SceneController& scene, QObject* parent = nullptr);

  std::size_t xInput() const { return x_input_; }
  std::size_t yInput() const { return y_input_; }
  /// The expert whose force is shown; nothing: the mean.
  std::optional<std::size_t> expert() const { return expert_; }

  /// The newest finished map, or null.
  const ForceMap* map() const { return map_ ? &*map_ : nullptr; }
  /// Nothing is left to compute.
  bool isFinest() const { return level_ == kSides.size(); }
  /// The force of the map's expert, or the mean, at the operating point.
  const fuzzy::Evaluation& forceAtPoint() const;
  /// The operating point on the axes and the force there, as it stands beside it: `300 mm, 50 mm/s   0.545 N`.
  QString pointText() const;

  /// A view of the map came to the screen. While there is none, nothing is computed.
  void addViewer() { ++viewers_; }
  /// It left the screen: what is not finished then waits for the next `update`.
  void removeViewer();

 public slots:
  /// Chooses the axes; equal inputs change places. Axes and expert stay chosen where another model has them too.
  void setAxes(std::size_t x_input, std::size_t y_input);
  void setExpert(std::optional<std::size_t> expert);
  /// Sees to it that the map is that of the scene as it is now: the first slice at once, the others from the event
  /// loop. Costs nothing where it is already, or is in work.
  void update();
  /// The same, to the end at once: some milliseconds for a few experts. For what has to be whole: a file, a picture.
  void finish();

 signals:
  /// The axes or the expert are others; the map is not computed yet.
  void choiceChanged();
  /// A map is there, the first of an order or a finer one.
  void mapChanged();

 private:
  void adoptModel();
  void applyPreset(const FigurePreset& preset);
  void dropPoint(std::size_t input);
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
  /// The same as ids, which hold for another model too; empty: nothing was chosen.
  std::string x_id_;
  std::string y_id_;
  std::string expert_id_;
  std::optional<ForceMap> map_;
  mutable std::optional<fuzzy::Evaluation> here_;  ///< at the operating point, computed when asked for
  int viewers_ = 0;
  bool stale_ = true;  ///< neither there nor in work for the scene as it is now

  // The order in work.
  std::shared_ptr<const OpenModel> model_;
  std::optional<fuzzy::Scene> order_;
  std::vector<double> point_;
  std::size_t level_ = kSides.size();  ///< index in kSides; past the end where nothing is in work
  std::size_t row_ = 0;
  double place_ns_ = 0;  ///< what a place took last; 0 before the first map
  ForceMap growing_;
  std::vector<double> xs_;
  std::vector<double> ys_;
  QTimer slices_;
};

}  // namespace tactus::workbench
