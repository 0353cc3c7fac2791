#include "app/workbench/tune/findings/findings_controller.h"

#include <algorithm>
#include <map>
#include <utility>

#include "app/editing/step_fixes.h"
#include "app/editing/lint_fixes.h"
#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_impact.h"
#include "core/base/check.h"

namespace tactus::workbench {

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
    take(report_, revision_);
    return;
  }
  begun_ = true;
  lint_worker_.run([this, ready = edits_.history().ready(),
                    revision = revision_](const std::stop_token& stop) -> Background::Deliver {
    auto report = std::make_shared<Report>(ready);
    report->lint = elicitation::ruleLint(ready->model, ready->compiled, {}, {}, stop);
    if (stop.stop_requested()) return {};
    report->findings = shownFindings(ready->model, ready->compiled, report->lint);
    return [this, report = std::shared_ptr<const Report>(std::move(report)), revision] { take(report, revision); };
  });
}

void FindingsController::take(std::shared_ptr<const Report> report, quint64 revision) {
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
