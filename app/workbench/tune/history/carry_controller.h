// Carries edits of an earlier version over to the open model: which there are, what each moves, and which are chosen.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/editing/rebase.h"
#include "app/workbench/base/computed.h"
#include "app/workbench/model/open_model.h"
#include "app/workbench/model/shown_impact.h"

namespace tactus::workbench {

class EditController;

/// One edit of the earlier version.
struct CarryRow {
  std::size_t edit = 0;  ///< of the rebase
  editing::CarriedEdit content;
  bool chosen = false;
  std::optional<editing::EditImpact> price;  ///< alone on the open model; nothing until it is known, or if it does not
                                             ///< apply
};

/// Thread: gui. Nothing is computed unless `list` is held.
class CarryController : public QObject {
  Q_OBJECT

 public:
  using Locks = std::function<std::vector<editing::VertexPlace>()>;
  using Curve = std::function<CurveSetting()>;

  /// `locks`: vertices that must not move; `curve`: the curve on the screen, of which no price shows less.
  CarryController(EditController& edits, Locks locks, Curve curve, QObject* parent = nullptr);

  /// The newest version before the build of the open model that was edited.
  struct Earlier {
    editing::StateId state = 0;
    std::size_t edits = 0;  ///< as many as it took
  };
  /// Nothing: there is none, or it cannot be read yet.
  std::optional<Earlier> earlier();

  /// The edits of `tuned` from now on, until `end` or until another model is opened.
  void begin(editing::StateId tuned);
  void end();
  bool isActive() const { return tuned_.has_value(); }
  /// The name of the version.
  QString source() const;
  /// Who signed off the version, and the open model as it is.
  QStringList sourceSignOffs() const;
  QStringList targetSignOffs() const;

  /// Those that can be carried over, then the others. Conflicts are not chosen until the user chooses them.
  const std::vector<CarryRow>& rows() const { return rows_; }
  std::size_t chosenCount() const;
  void choose(std::size_t row, bool chosen);
  void chooseAll(bool chosen);
  /// What the chosen ones move together; null until it is known.
  const editing::EditImpact* together() const;
  /// Why there is no list; empty if there is one or one is to come.
  QString failure() const;
  Computation& list() { return list_; }
  Computation& sum() { return sum_; }
  /// The unit of the force of the open model.
  std::string unit() const;
  /// A place of the open model in words.
  QString placeText(const std::vector<double>& at) const;

  /// Shows the edit of `row` on the curves, as a ghost; nothing: none.
  void preview(std::optional<std::size_t> row);
  /// Makes the chosen edits as one step. Returns false if it is refused.
  bool carry();

 signals:
  void rowsChanged();
  /// The model with the edit that is previewed, and its name; null: none.
  void previewed(const std::shared_ptr<const tactus::workbench::OpenModel>& model, const QString& name);

 private:
  struct ListInputs {
    editing::SharedModel base;
    editing::SharedModel tuned;
    editing::SharedModel target;
    std::vector<editing::VertexPlace> locked;
    CurveSetting curve;
  };
  struct List {
    std::shared_ptr<const editing::Rebase> rebase;
    std::vector<std::optional<editing::EditImpact>> prices;
  };
  struct SumInputs {
    std::shared_ptr<const editing::Rebase> rebase;
    std::vector<std::size_t> chosen;
    CurveSetting curve;
  };

  static base::Result<editing::EditImpact> price(const editing::Rebase& rebase, std::span<const std::size_t> chosen,
                                                 const CurveSetting& curve);
  std::optional<ListInputs> listInputs();
  std::optional<SumInputs> sumInputs() const;
  void followHistory();
  void takeList();
  std::vector<std::size_t> chosen() const;
  QStringList signOffsOf(editing::StateId state) const;

  EditController& edits_;
  const Locks locks_;
  const Curve curve_;
  std::optional<editing::StateId> tuned_;
  std::optional<editing::StateId> target_;  ///< the state that the list is of
  QString unread_;                          ///< why the versions could not be read
  std::vector<CarryRow> rows_;
  std::map<std::string, bool> asked_;  ///< what the user chose, by the words of the edit
  Computed<ListInputs, List> list_;
  Computed<SumInputs, editing::EditImpact> sum_;
};

}  // namespace tactus::workbench
