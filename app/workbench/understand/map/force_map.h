// Keeps the force map of the scene up to date for all views: what of it is computed, when, and on which thread.
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/workbench/base/worker.h"
#include "app/workbench/understand/map/map_request.h"

namespace tactus::workbench {

class SceneController;
struct FigurePreset;

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
  void applyPreset(const FigurePreset& preset);
  void dropPoint(std::size_t input);
  void dropPart(const std::string& input_id);
  void stop();
  std::optional<std::size_t> finestWithin(double ms) const;
  bool computeNow(std::size_t level, const std::function<bool()>& goes_on);
  void computeBehind();
  void take(ForceMap map, std::size_t level, double cpu_ns);

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

}  // namespace tactus::workbench
