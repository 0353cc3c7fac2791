// What the lint finds in the open model, kept up to date after each edit on a thread of its own, and the edits that
// would settle the chosen finding. How many findings the last edit added is known whether the panel is seen or not;
// fixes are computed while it is.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "app/editing/edit.h"
#include "app/workbench/base/background.h"
#include "app/workbench/tune/findings/shown_finding.h"

namespace tactus::workbench {

class EditController;
class SceneController;

/// One way to settle a finding.
struct FixOffer {
  QString text;    ///< of the button
  QString effect;  ///< `max ΔF 0.032 N (0.4 JND)`
  QString what;    ///< what would stand in the undo list
  editing::Edit edit;
};

/// Thread: gui.
class FindingsController : public QObject {
  Q_OBJECT

 public:
  /// Lints the model of `edits`; a chosen finding moves the operating point of `scene`. Both outlive this.
  FindingsController(EditController& edits, SceneController& scene, QObject* parent = nullptr);

  /// Enable while the panel is visible: fixes of the chosen finding are computed only then.
  void setWatched(bool watched);

  /// The findings of the model as it was linted last.
  const std::vector<ShownFinding>& findings() const { return *shared(); }
  /// The same, to keep; other findings are another list.
  std::shared_ptr<const std::vector<ShownFinding>> shared() const;
  /// Whether they are of the model as it stands. Otherwise they are being refreshed.
  bool isCurrent() const { return report_ != nullptr && linted_ == revision_; }
  /// How many findings the last edit added; 0 for a model that was opened, and until the edit was linted.
  std::size_t added() const { return isCurrent() ? added_ : 0; }
  /// The reachable range, the completeness and the rest of the lint; null before the first one.
  const elicitation::RuleLint* lint() const;
  /// The model that was linted.
  const fuzzy::ForceModel* lintedModel() const;

  /// Index of the chosen finding.
  std::optional<std::size_t> chosen() const { return chosen_; }
  /// The ways to settle it; empty while they are computed and where there is none.
  const std::vector<FixOffer>& fixes() const { return fixes_; }
  /// Whether fixes may still come.
  bool isLookingForFixes() const { return fix_worker_.isBusy(); }

 public slots:
  /// Chooses a finding: the operating point goes there, and its fixes are computed.
  void choose(std::size_t index);
  void clearChoice();
  /// The operating point goes to where the change of the force ends, or to where it begins.
  void goTo(bool other_end);
  /// Carries out a fix of the chosen finding as one entry of the undo list. A fix that was made of another model than
  /// the one that is open is refused. Returns whether it was carried out.
  bool apply(std::size_t fix);

 signals:
  /// Other findings, or they became old or current.
  void changed();
  void chosenChanged();
  void fixesChanged();
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
  quint64 revision_ = 0;  ///< of the model; every change of it counts
  quint64 linted_ = 0;    ///< of the report
  bool begun_ = false;    ///< the lint of the present revision was asked for
  std::shared_ptr<const Report> report_;
  std::size_t added_ = 0;
  std::optional<std::size_t> chosen_;
  std::vector<FixOffer> fixes_;
  Background lint_worker_;
  Background fix_worker_;
};

}  // namespace tactus::workbench
