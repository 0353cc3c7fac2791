// The findings of the lint for the open model, updated on a separate thread after each edit, and the edits that would
// fix the chosen finding. The number of findings added by the last edit is always known; fixes are computed only while
// the panel is visible.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
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
  void take(std::shared_ptr<const Report> report, quint64 revision);
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

}  // namespace tactus::workbench
