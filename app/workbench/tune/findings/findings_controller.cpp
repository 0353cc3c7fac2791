#include "app/workbench/tune/findings/findings_controller.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringList>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/lint_fixes.h"
#include "app/editing/step_fixes.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_impact.h"
#include "core/base/check.h"

namespace tactus::workbench {
namespace {

using FindingKind = elicitation::RuleFinding::Kind;

struct FindingRowsText {
  Q_DECLARE_TR_FUNCTIONS(FindingRowsText)
};

QString countText(FindingKind kind, int n) {
  switch (kind) {
    case FindingKind::kHole: return FindingRowsText::tr("%n hole(s)", nullptr, n);
    case FindingKind::kAbstentionJump: return FindingRowsText::tr("%n jump(s) of the mean", nullptr, n);
    case FindingKind::kForceStep: return FindingRowsText::tr("%n step(s) of the force", nullptr, n);
    case FindingKind::kRegionWithoutRule: return FindingRowsText::tr("%n region(s) without a rule", nullptr, n);
    case FindingKind::kMissingItem: return FindingRowsText::tr("%n missing answer(s)", nullptr, n);
    case FindingKind::kConflict: return FindingRowsText::tr("%n conflict(s)", nullptr, n);
    case FindingKind::kExpertsApart: return FindingRowsText::tr("apart at %n place(s)", nullptr, n);
    case FindingKind::kAgainstDeclaration: return FindingRowsText::tr("%n step(s) against the declaration", nullptr, n);
    case FindingKind::kLevelJump: return FindingRowsText::tr("%n jump(s)", nullptr, n);
    case FindingKind::kDirectionChange: return FindingRowsText::tr("%n change(s) of direction", nullptr, n);
    case FindingKind::kDisagreement: return FindingRowsText::tr("%n disagreement(s)", nullptr, n);
    case FindingKind::kRedundantRule: return FindingRowsText::tr("%n redundant rule(s)", nullptr, n);
    case FindingKind::kUnreachableRule: return FindingRowsText::tr("%n rule(s) that never fire", nullptr, n);
    case FindingKind::kUnreachableTerm: return FindingRowsText::tr("%n unreachable term(s)", nullptr, n);
    case FindingKind::kUnusedTerm: return FindingRowsText::tr("%n unused term(s)", nullptr, n);
  }
  return {};
}

std::optional<double> mostNewtons(const std::vector<ShownFinding>& all, const std::vector<std::size_t>& group) {
  std::optional<double> most;
  for (const std::size_t finding : group) most = std::max(most, all[finding].finding.newtons);
  return most;
}

void sort(std::vector<std::size_t>& passing, const std::vector<ShownFinding>& all, FindingOrder order) {
  // Findings that are equal in the order stay in that of the newtons; those without a place come last.
  if (order == FindingOrder::kExpert) {
    std::stable_sort(passing.begin(), passing.end(),
                     [&](std::size_t a, std::size_t b) { return all[a].who < all[b].who; });
  }
  if (order == FindingOrder::kPlace) {
    std::stable_sort(passing.begin(), passing.end(), [&](std::size_t a, std::size_t b) {
      const auto& one = all[a].along;
      const auto& other = all[b].along;
      return one && other ? *one < *other : one.has_value() && !other.has_value();
    });
  }
}

}  // namespace

QString groupKey(const ShownFinding& shown) {
  return QStringLiteral("%1\n%2\n%3\n%4")
      .arg(static_cast<int>(shown.finding.kind))
      .arg(static_cast<int>(shown.acceptance))
      .arg(shown.who, shown.step);
}

QString groupTitle(const ShownFinding& shown, std::size_t count) {
  const QString what = countText(shown.finding.kind, static_cast<int>(count));
  return shown.step.isEmpty() ? FindingRowsText::tr("%1: %2").arg(shown.who, what)
                              : FindingRowsText::tr("%1 · %2: %3").arg(shown.who, shown.step, what);
}

std::vector<FindingRow> findingRows(const std::vector<ShownFinding>& all, std::vector<std::size_t> passing,
                                    FindingOrder order, const QSet<QString>& unfolded) {
  sort(passing, all, order);
  QHash<QString, std::vector<std::size_t>> groups;
  for (const std::size_t finding : passing) groups[groupKey(all[finding])].push_back(finding);
  std::vector<FindingRow> rows;
  for (const std::size_t finding : passing) {
    const QString key = groupKey(all[finding]);
    const std::vector<std::size_t>& group = groups[key];
    if (group.size() < kSmallestGroup) {
      rows.push_back({finding});
    } else if (group.front() == finding) {
      const bool open = unfolded.contains(key);
      rows.push_back({finding, group.size(), false, open, mostNewtons(all, group)});
      if (!open) continue;
      for (const std::size_t member : group) rows.push_back({member, 0, true});
    }
  }
  return rows;
}

FindingsModel::FindingsModel(const FindingsController& findings, QObject* parent)
    : QAbstractListModel(parent), findings_(findings) {}

void FindingsModel::setKind(std::optional<elicitation::RuleFinding::Kind> kind) {
  if (kind == kind_) return;
  kind_ = kind;
  adopt();
}

void FindingsModel::setWho(const QString& who) {
  if (who == who_) return;
  who_ = who;
  adopt();
}

void FindingsModel::setOrder(FindingOrder order) {
  if (order == order_) return;
  order_ = order;
  adopt();
}

void FindingsModel::fold(int row) {
  const QString key = groupKey(findingAt(row));
  if (!unfolded_.remove(key)) unfolded_.insert(key);
  adopt();
}

QString FindingsModel::titleAt(int row) const { return groupTitle(findingAt(row), rowAt(row).members); }

int FindingsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant FindingsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const ShownFinding& shown = findingAt(index.row());
  if (isHeading(index.row())) {
    if (role == Qt::ToolTipRole) return tr("Click to see each of them");
    return role == Qt::DisplayRole || role == Qt::AccessibleTextRole ? QVariant(titleAt(index.row())) : QVariant();
  }
  if (role == Qt::DisplayRole) return shown.sentence;
  if (role == Qt::ToolTipRole) {
    QStringList lines = {shown.sentence};
    if (shown.finding.at_least) lines << tr("≥: the largest force of the tested settings");
    if (shown.noticeable) lines << explained(Statistic::kNoticeable);
    return lines.join(QLatin1Char('\n'));
  }
  // What a screen reader says.
  if (role == Qt::AccessibleTextRole) return QStringLiteral("%1, %2: %3").arg(shown.kind, shown.who, shown.sentence);
  return {};
}

int FindingsModel::rowOf(std::size_t index) const {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (rows_[row].finding == index && rows_[row].members == 0) return static_cast<int>(row);
  }
  if (index >= all_->size()) return -1;
  const QString key = groupKey((*all_)[index]);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (rows_[row].members > 0 && groupKey((*all_)[rows_[row].finding]) == key) return static_cast<int>(row);
  }
  return -1;
}

bool FindingsModel::isCurrent() const { return all_ == findings_.shared(); }

void FindingsModel::adopt() {
  beginResetModel();
  all_ = findings_.shared();
  std::set<std::string> experts;
  if (const fuzzy::ForceModel* const model = findings_.lintedModel(); model != nullptr && !who_.isEmpty()) {
    for (const fuzzy::Expert& expert : model->experts) {
      if (labelOf(expert) == who_) experts.insert(expert.id);
    }
  }
  std::vector<std::size_t> passing;
  for (std::size_t i = 0; i < all_->size(); ++i) {
    if (passes((*all_)[i], experts)) passing.push_back(i);
  }
  rows_ = findingRows(*all_, std::move(passing), order_, unfolded_);
  endResetModel();
}

bool FindingsModel::passes(const ShownFinding& shown, const std::set<std::string>& experts) const {
  if (kind_ && shown.finding.kind != *kind_) return false;
  if (who_.isEmpty() || shown.who == who_) return true;
  return std::any_of(shown.finding.experts.begin(), shown.finding.experts.end(),
                     [&](const std::string& id) { return experts.contains(id); });
}

/// Never changes once it is made, so both threads may read it.
struct FindingsController::Report {
  explicit Report(editing::SharedModel linted) : ready(std::move(linted)) {}

  const fuzzy::ForceModel& model() const { return ready->model; }

  editing::SharedModel ready;
  elicitation::RuleLint lint;
  std::vector<ShownFinding> findings;
};

namespace {

bool sameFinding(const ShownFinding& one, const ShownFinding& other) {
  return one.finding.kind == other.finding.kind && one.finding.experts == other.finding.experts &&
         one.finding.where == other.finding.where && one.finding.place == other.finding.place &&
         one.acceptance == other.acceptance;
}

// What the curve on the screen would show of a fix.
std::optional<editing::GhostCurve> curveOf(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                           const editing::Edit& edit, const CurveSetting& curve) {
  if (curve.values.size() != model.inputs.size()) return std::nullopt;
  return curveBetween(model, compiled, edit.model, edit.compiled, curve);
}

// Findings of `now` that none of `before` can have become: an edit that moves a hole makes no new one.
std::size_t addedTo(const std::vector<ShownFinding>& before, const std::vector<ShownFinding>& now) {
  using KindAndPlace = std::pair<elicitation::RuleFinding::Kind, std::vector<std::string>>;
  std::map<KindAndPlace, std::ptrdiff_t> more;
  const auto count = [&more](const std::vector<ShownFinding>& findings, std::ptrdiff_t by) {
    for (const ShownFinding& shown : findings) {
      if (shown.acceptance != Acceptance::kLapsed) more[{shown.finding.kind, shown.finding.experts}] += by;
    }
  };
  count(now, 1);
  count(before, -1);
  std::size_t added = 0;
  for (const auto& [kind, difference] : more)
    added += static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, difference));
  return added;
}

std::vector<FixOffer> offersFor(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                const ShownFinding& shown, const CurveSetting& curve, const std::stop_token& stop) {
  std::vector<FixOffer> out;
  if (shown.acceptance == Acceptance::kLapsed) {
    if (auto edit = editing::forgetLapsed(model)) {
      const QString what = text(edit->label);
      out.push_back({FindingsController::tr("Remove it from the model"), impactText({}, {}), what, std::move(*edit)});
    }
    return out;
  }
  for (editing::Fix& fix : editing::fixesFor(model, compiled, shown.finding, stop)) {
    const QString what = text(fix.edit.label);
    const auto seen = curveOf(model, compiled, fix.edit, curve);
    if (seen) editing::include(fix.impact, *seen, curve.x_input, curve.values);
    out.push_back({text(fix.text), impactText(fix.impact, model.output.unit), what, std::move(fix.edit)});
  }
  return out;
}

/// The id of the input that a finding is about most.
QString inputOf(const fuzzy::ForceModel& model, const elicitation::RuleFinding& finding) {
  const auto input = analysis::inputOf(finding.where, model);
  return input ? text(model.inputs[*input].id) : QString();
}

}  // namespace

FindingsController::FindingsController(EditController& edits, SceneController& scene, QObject* parent)
    : QObject(parent), edits_(edits), scene_(scene) {
  connect(&edits_, &EditController::modelReset, this, &FindingsController::adoptModel);
  connect(&edits_, &EditController::changed, this, &FindingsController::onModel);
}

void FindingsController::setWatched(bool watched) {
  watched_ = watched;
  if (watched) {
    refresh();
    return;
  }
  fix_worker_.drop();
}

std::shared_ptr<const std::vector<ShownFinding>> FindingsController::shared() const {
  static const auto none = std::make_shared<const std::vector<ShownFinding>>();
  return report_ ? std::shared_ptr<const std::vector<ShownFinding>>(report_, &report_->findings) : none;
}

const elicitation::RuleLint* FindingsController::lint() const { return report_ ? &report_->lint : nullptr; }

const fuzzy::ForceModel* FindingsController::lintedModel() const { return report_ ? &report_->model() : nullptr; }

void FindingsController::choose(std::size_t index) {
  TACTUS_CHECK(index < findings().size());
  chosen_ = index;
  dropFixes();
  emit chosenChanged();
  goTo(false);
  findFixes();
  const auto& finding = report_->findings[index].finding;
  emit lookedAt(finding.experts.size() == 1 ? text(finding.experts.front()) : QString(),
                inputOf(report_->model(), finding));
}

void FindingsController::clearChoice() {
  if (!chosen_) return;
  chosen_.reset();
  dropFixes();
  emit chosenChanged();
}

void FindingsController::goTo(bool other_end) {
  if (!chosen_ || scene_.model() == nullptr) return;
  const ShownFinding& shown = findings()[*chosen_];
  const auto& place = other_end ? shown.other_end : shown.at;
  // Inputs are those of the file, but another file may have come since.
  if (place.size() != scene_.model()->model.inputs.size()) return;
  scene_.clearHover();
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i]) scene_.setValue(i, *place[i]);
  }
}

void FindingsController::pointAt(std::size_t rule) {
  // The rules of another model have other numbers.
  if (!chosen_ || !isCurrent() || rule >= findings()[*chosen_].rules.size()) return;
  const RuleOfExpert& pointed = findings()[*chosen_].rules[rule];
  emit rulePointed(text(pointed.expert), pointed.rule);
}

bool FindingsController::apply(std::size_t fix) {
  if (fix >= fixes_.size() || !isCurrent() || edits_.inGesture()) {
    edits_.refuse(tr("The model changed since this fix was made; the new findings will be there in a moment."));
    return false;
  }
  editing::Edit edit = std::move(fixes_[fix].edit);
  dropFixes();
  return edits_.apply(std::move(edit));
}

void FindingsController::adoptModel() {
  report_.reset();
  added_ = 0;
  chosen_.reset();
  onModel();
  emit chosenChanged();
}

void FindingsController::onModel() {
  ++revision_;
  begun_ = false;
  lint_worker_.drop();
  dropFixes();
  emit changed();
  // A drag is linted when it ends: findings on its way are too short-lived to read, and the servo and the plots need
  // the time.
  if (!edits_.inGesture()) refresh();
}

void FindingsController::refresh() {
  if (!edits_.isOpen() || edits_.inGesture()) return;
  if (isCurrent()) {
    if (watched_ && chosen_ && fixes_.empty() && !isLookingForFixes()) findFixes();
    return;
  }
  if (begun_) return;
  if (report_ && editing::sameBits(report_->model(), edits_.model())) {
    setReport(report_, revision_);
    return;
  }
  begun_ = true;
  lint_worker_.run([this, ready = edits_.history().ready(),
                    revision = revision_](const std::stop_token& stop) -> Background::Deliver {
    auto report = std::make_shared<Report>(ready);
    report->lint = elicitation::ruleLint(ready->model, ready->compiled, {}, {}, stop);
    if (stop.stop_requested()) return {};
    report->findings = shownFindings(ready->model, ready->compiled, report->lint);
    return [this, report = std::shared_ptr<const Report>(std::move(report)), revision] { setReport(report, revision); };
  });
}

void FindingsController::setReport(std::shared_ptr<const Report> report, quint64 revision) {
  if (revision != revision_) return;
  const auto before = std::exchange(report_, std::move(report));
  linted_ = revision;
  if (before != nullptr && before != report_) added_ = addedTo(before->findings, report_->findings);
  if (chosen_ && before) {
    const ShownFinding& was = before->findings[*chosen_];
    const auto& now = report_->findings;
    const auto same = std::find_if(now.begin(), now.end(), [&](const auto& one) { return sameFinding(one, was); });
    chosen_ = same == now.end() ? std::nullopt : std::optional(static_cast<std::size_t>(same - now.begin()));
  }
  emit changed();
  emit chosenChanged();
  findFixes();
}

void FindingsController::dropFixes() {
  fix_worker_.drop();
  fixes_.clear();
  emit fixesChanged();
}

void FindingsController::findFixes() {
  if (!watched_ || !chosen_ || !isCurrent()) return;
  fix_worker_.run(
      [this, report = report_, index = *chosen_, revision = revision_,
       curve = CurveSetting{scene_.xInput(), scene_.values()}](const std::stop_token& stop) -> Background::Deliver {
        auto offers = std::make_shared<std::vector<FixOffer>>(
            offersFor(report->model(), report->ready->compiled, report->findings[index], curve, stop));
        return [this, offers, index, revision] {
          if (revision != revision_ || chosen_ != index) return;
          fixes_ = std::move(*offers);
          emit fixesChanged();
        };
      });
  emit fixesChanged();
}

}  // namespace tactus::workbench
