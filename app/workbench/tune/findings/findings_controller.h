// The findings of the lint for the open model, updated on a separate thread after each edit, and the edits that would
// fix the chosen finding. The number of findings added by the last edit is always known; fixes are computed only while
// the panel is visible.
#pragma once

#include <QAbstractListModel>
#include <QObject>
#include <QSet>
#include <QString>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/editing/edit.h"
#include "app/workbench/base/worker.h"
#include "app/workbench/tune/findings/shown_finding.h"

namespace tactus::workbench {

class EditController;
class SceneController;

/// One way to fix a finding.
struct FixOffer {
  QString text;    ///< of the button
  QString effect;  ///< `max ΔF 0.032 N (0.4 JND)`
  QString what;    ///< the entry in the undo list
  editing::Edit edit;
};

/// Thread: gui.
class FindingsController : public QObject {
  Q_OBJECT

 public:
  /// Lints the model of `edits`. A chosen finding moves the operating point of `scene`. Both outlive this.
  FindingsController(EditController& edits, SceneController& scene, QObject* parent = nullptr);

  /// Enable while the panel is visible: fixes of the chosen finding are computed only then.
  void setWatched(bool watched);

  /// The findings of the last lint.
  const std::vector<ShownFinding>& findings() const { return *shared(); }
  /// The same list as shared ownership. It never changes; new findings make a new list.
  std::shared_ptr<const std::vector<ShownFinding>> shared() const;
  /// Whether the findings belong to the current model. If not, a new lint is on its way.
  bool isCurrent() const { return report_ != nullptr && linted_ == revision_; }
  /// How many findings the last edit added; 0 for a model as opened, and until the edit is linted.
  std::size_t added() const { return isCurrent() ? added_ : 0; }
  /// The last lint: reachable range, completeness and the rest; null before the first one.
  const elicitation::RuleLint* lint() const;
  /// The model that was linted.
  const fuzzy::ForceModel* lintedModel() const;

  /// Index of the chosen finding.
  std::optional<std::size_t> chosen() const { return chosen_; }
  /// The fixes of the chosen finding; empty while they are computed and if there is none.
  const std::vector<FixOffer>& fixes() const { return fixes_; }
  /// Whether fixes may still arrive.
  bool isLookingForFixes() const { return fix_worker_.isBusy(); }

 public slots:
  /// Chooses a finding: moves the operating point to it, and computes its fixes.
  void choose(std::size_t index);
  void clearChoice();
  /// Moves the operating point to the end of the change of force (false) or to its beginning (true).
  void goTo(bool other_end);
  /// Points at rule `rule` of those that the chosen finding names.
  void pointAt(std::size_t rule);
  /// Applies a fix of the chosen finding as one entry of the undo list. Refused: a fix made from another model than the
  /// open one. Returns whether it was applied.
  bool apply(std::size_t fix);

 signals:
  /// New findings, or they became old or current.
  void changed();
  void chosenChanged();
  void fixesChanged();
  /// The user asks for a rule that a finding names.
  void rulePointed(const QString& expert, std::size_t rule);
  /// A finding of this expert, about this input, was chosen; either may be empty.
  void lookedAt(const QString& expert, const QString& input);

 private:
  struct Report;

  void adoptModel();
  void onModel();
  void refresh();
  void setReport(std::shared_ptr<const Report> report, quint64 revision);
  void dropFixes();
  void findFixes();

  EditController& edits_;
  SceneController& scene_;
  bool watched_ = false;
  quint64 revision_ = 0;  ///< counts the changes of the model
  quint64 linted_ = 0;    ///< revision of the report
  bool begun_ = false;    ///< the lint of the current revision has started
  std::shared_ptr<const Report> report_;
  std::size_t added_ = 0;
  std::optional<std::size_t> chosen_;
  std::vector<FixOffer> fixes_;
  Background lint_worker_;
  Background fix_worker_;
};

// The findings of the lint as a list: filtered by kind and expert, in the chosen order, and in groups that fold.

/// The rows in which the findings are listed: in a chosen order, and findings of one kind about the same thing as a
/// group that folds:
///   S2 · Nasopharynx → Oropharynx: 6 jumps
enum class FindingOrder { kNewtons, kExpert, kPlace };

/// So many findings about one thing make a group; fewer are read as fast one by one.
inline constexpr std::size_t kSmallestGroup = 3;

struct FindingRow {
  std::size_t finding = 0;             ///< index; of a heading: its first finding
  std::size_t members = 0;             ///< of a heading: how many findings it stands for; 0 for a finding
  bool in_group = false;               ///< a finding below its heading
  bool unfolded = false;               ///< of a heading
  std::optional<double> newtons = {};  ///< of a heading: the largest of its findings
};

/// What a finding has in common with those of its group.
QString groupKey(const ShownFinding& shown);
/// The heading of a group of `count` findings like `shown`.
QString groupTitle(const ShownFinding& shown, std::size_t count);

/// `passing`: the indices in `all` to list, in the order of the newtons. `unfolded`: the keys of groups whose findings
/// are listed below their heading.
std::vector<FindingRow> findingRows(const std::vector<ShownFinding>& all, std::vector<std::size_t> passing,
                                    FindingOrder order, const QSet<QString>& unfolded);

class FindingsModel : public QAbstractListModel {
  Q_OBJECT

 public:
  explicit FindingsModel(const FindingsController& findings, QObject* parent = nullptr);

  /// Filters by kind; nothing: all kinds.
  void setKind(std::optional<elicitation::RuleFinding::Kind> kind);
  /// Filters by the text in ShownFinding::who; empty: all. A finding about two experts passes for each of them.
  void setWho(const QString& who);

  void setOrder(FindingOrder order);
  /// Folds a group or unfolds it; `row` is its heading.
  void fold(int row);

  int rowCount(const QModelIndex& parent = {}) const override;
  /// Qt::DisplayRole: the sentence; the whole finding comes from findingAt.
  QVariant data(const QModelIndex& index, int role) const override;

  const FindingRow& rowAt(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  bool isHeading(int row) const { return rowAt(row).members > 0; }
  /// `S2 · Nasopharynx → Oropharynx: 6 jumps`. `row` is a heading.
  QString titleAt(int row) const;
  /// Index of the finding in row `row` in FindingsController::findings.
  std::size_t indexAt(int row) const { return rowAt(row).finding; }
  const ShownFinding& findingAt(int row) const { return (*all_)[indexAt(row)]; }
  /// The row of a finding with that index, or of the heading of its folded group; -1 if it is filtered out.
  int rowOf(std::size_t index) const;

  /// Whether the rows show the controller's current findings. A hidden list may be old.
  bool isCurrent() const;
  /// Takes the controller's current findings.
  void adopt();

 private:
  bool passes(const ShownFinding& shown, const std::set<std::string>& experts) const;

  const FindingsController& findings_;
  std::optional<elicitation::RuleFinding::Kind> kind_;
  QString who_;
  FindingOrder order_ = FindingOrder::kNewtons;
  QSet<QString> unfolded_;                                ///< keys of groups
  std::shared_ptr<const std::vector<ShownFinding>> all_;  ///< null before the first `adopt`
  std::vector<FindingRow> rows_;
};

}  // namespace tactus::workbench
