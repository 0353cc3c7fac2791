// Pulling a force curve: the user says where the force should go, and gets the smallest edits of the model that bring
// it there, each with what it moves elsewhere. Nothing changes before one of them is taken.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/editing/membership_edits.h"
#include "app/workbench/base/computed.h"
#include "app/workbench/model/open_model.h"
#include "core/analysis/pull/pull.h"
#include "core/analysis/pull/pull_text.h"

namespace tactus::workbench {

class EditController;
class SceneController;

/// Where the force should go.
struct PullWish {
  enum class Kind {
    kPoint,      ///< to `force_n` at `from`
    kBand,       ///< into [low_n, high_n] from `from` to `to`
    kReference,  ///< to the curve `name`
  };
  Kind kind = Kind::kPoint;
  double from = 0;  ///< of the input on the x axis, in its unit
  double to = 0;
  double force_n = 0;
  double low_n = 0;
  double high_n = 0;
  QString name;
  std::vector<double> x;    ///< ascending; of the reference
  std::vector<double> y_n;  ///< one per place; NaN: a gap
};

inline PullWish pointWish(double x, double force_n) {
  return {PullWish::Kind::kPoint, x, x, force_n, 0, 0, {}, {}, {}};
}
inline PullWish bandWish(double from, double to, double low_n, double high_n) {
  return {PullWish::Kind::kBand, from, to, 0, low_n, high_n, {}, {}, {}};
}

/// An edit that is offered, or several that belong together.
struct PullOffer {
  std::vector<analysis::PullEdit> edits;
  QString what;           ///< in words, with the force that it gives where that is not the wanted one
  QString price;          ///< what it moves elsewhere
  QStringList notes;      ///< whose answers it contradicts, who shares the words, new findings; each a sentence
  bool folded = false;    ///< not plausible
  std::vector<double> x;  ///< along the input on the x axis
  std::vector<fuzzy::Evaluation> curve;  ///< the pulled line after it, one per place
};

struct PullAnswer {
  std::optional<double> now_n;                   ///< at the point; nothing in a hole
  std::optional<analysis::ForceInterval> reach;  ///< at the point, by one edit
  QString sentence;                              ///< what can be reached, or what is in the way
  std::vector<PullOffer> offers;  ///< best first: up to three plausible ones of different kinds, then others
};

/// Thread: gui.
class PullController : public QObject {
  Q_OBJECT

 public:
  using Locks = std::function<std::vector<editing::VertexPlace>()>;

  /// `locks`: the vertices that must stay, asked for with each wish.
  PullController(EditController& edits, const SceneController& scene, Locks locks, QObject* parent = nullptr);

  enum class State {
    kIdle,
    kPulling,   ///< a drag: the best edit alone is sought
    kChoosing,  ///< all edits, with their notes
  };
  State state() const { return state_; }
  const PullWish& wish() const { return wish_; }
  /// The expert whose own force is pulled; nothing: the mean.
  std::optional<std::size_t> expert() const { return expert_; }
  /// Of the newest wish or of one shortly before; null until the first.
  const PullAnswer* answer() const { return search_.value().get(); }
  /// `answer` is not of the newest wish yet.
  bool isSearching() const { return !search_.of() || search_.of()->number != asked_; }
  /// Why nothing can be sought; empty if something can.
  const QString& failure() const { return search_.failure(); }
  /// The offer that is looked at: the best one until `preview`. Nothing without offers.
  std::optional<std::size_t> previewed() const;
  /// Who approved the model as it is: an edit makes a version that they have not felt.
  QStringList approvedBy() const;
  std::size_t lockedVertices() const { return locks_().size(); }
  /// The points at which the force must stay, whatever is pulled: one value per input. They stay until they are taken
  /// away, or a model is opened that has no such points.
  const std::vector<std::vector<double>>& pins() const { return pins_; }
  const SceneController& scene() const { return scene_; }

 public slots:
  /// Begins with `wish` for the line of `expert`. Refused in one sentence (EditController::refused) while another
  /// version is shown. A model must be open.
  void begin(const tactus::workbench::PullWish& wish, std::optional<std::size_t> expert,
             tactus::workbench::PullController::State state);
  void setWish(const tactus::workbench::PullWish& wish);
  void setExpert(std::optional<std::size_t> expert);
  /// The drag ended: the user chooses.
  void choose();
  void preview(std::size_t offer);
  /// Pins the force at `point`, or takes the pin away that is there. Refused in one sentence where no rule fires.
  void togglePin(const std::vector<double>& point);
  void clearPins();
  /// Makes the edits of an offer, as one step of undo, and ends.
  void take(std::size_t offer);
  void cancel();

 signals:
  /// Wish, expert, state, answer, preview or pins.
  void changed();

 private:
  struct Question {
    std::shared_ptr<const OpenModel> open;
    PullWish wish;
    std::vector<double> point;
    std::size_t x_input = 0;
    analysis::PullSettings settings;
    bool whole = false;  ///< all offers with notes, not the best alone
    std::uint64_t number = 0;
  };
  using Search = Computed<Question, PullAnswer>;

  /// What the lint finds in the model that is pulled: the same for each wish.
  struct Linted {
    std::weak_ptr<const OpenModel> of;
    std::shared_ptr<const analysis::NewFindings> findings;
  };
  static Search::Answer answerOf(const Question& question, const RunOf<PullAnswer>& run, Linted& linted);
  Question question() const;
  void ask();
  void enter(State state);
  void endIfMoved();
  void keepPins();

  EditController& edits_;
  const SceneController& scene_;
  Locks locks_;
  State state_ = State::kIdle;
  PullWish wish_;
  std::optional<std::size_t> expert_;
  std::optional<std::size_t> previewed_;
  std::vector<std::vector<double>> pins_;
  std::shared_ptr<const OpenModel> open_;  ///< at the beginning
  std::vector<double> values_;             ///< likewise
  std::size_t x_input_ = 0;                ///< likewise
  std::uint64_t asked_ = 0;                ///< number of the newest question
  Search search_;
};

}  // namespace tactus::workbench
