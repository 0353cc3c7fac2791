#include "app/editing/earlier_history.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/base/check.h"
#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"

namespace tactus::editing {
namespace {

using base::Result;
using study::ModelVersion;

constexpr std::string_view kDrag = "drag: ";
constexpr const char* kElsewhere = "another program";

bool haveSameInputs(const fuzzy::ForceModel& one, const fuzzy::ForceModel& other) {
  return std::equal(one.inputs.begin(), one.inputs.end(), other.inputs.begin(), other.inputs.end(),
                    [](const fuzzy::Variable& a, const fuzzy::Variable& b) { return a.id == b.id; });
}

}  // namespace

std::size_t editsIn(std::span<const ModelVersion> versions) {
  return static_cast<std::size_t>(std::count_if(versions.begin(), versions.end(), [](const ModelVersion& version) {
    return version.label.starts_with(name(EventKind::kEdit));
  }));
}

Result<EditHistory> wholeHistory(const KeptVersions& kept, study::RecordIds ids, const Stamp& stamp) {
  auto history = historyFrom(kept.versions, ids, 0);
  if (!history || !kept.unfinished) return history;
  auto edit = finished(kept.unfinished->model, kept.unfinished->label + " (recovered)");
  if (!edit) return tl::unexpected(std::move(edit.error()));
  history->apply(std::move(*edit), stamp);
  return history;
}

ModelVersion dragVersion(const EditHistory& history, study::RecordIds& ids, std::int64_t utc_ms) {
  fuzzy::ForceModel model = history.model();
  refreshChecks(model, history.compiled());
  ModelVersion out;
  out.id = ids.next();
  out.parent = history.versionOf(history.current());
  out.utc_ms = utc_ms;
  out.label = std::string(kDrag) + history.gestureLabel();
  out.text = model_io::formatModel(model);
  out.sha256 = base::sha256(out.text);
  return out;
}

bool isDrag(const ModelVersion& version) { return version.label.starts_with(kDrag); }

Result<KeptVersions> withoutDrags(std::vector<ModelVersion> versions) {
  KeptVersions out;
  std::optional<ModelVersion> drag;
  if (!versions.empty() && isDrag(versions.back())) drag = versions.back();
  std::erase_if(versions, isDrag);
  out.versions = std::move(versions);
  if (!drag || (!out.versions.empty() && out.versions.back().sha256 == drag->sha256)) return out;
  auto model = model_io::parseModel(drag->text, "model version " + study::toText(drag->id));
  if (!model) return tl::unexpected(std::move(model.error()));
  out.unfinished = Unfinished{drag->label.substr(kDrag.size()), std::move(model->model)};
  return out;
}

Result<EarlierHistory> goOn(KeptVersions kept, const EditHistory& fresh, study::RecordIds ids,
                            const std::string& changed_label, const Stamp& stamp) {
  std::vector<ModelVersion>& versions = kept.versions;
  if (versions.empty()) return base::fail(base::ErrorCode::kData, "model versions", "none", "one or more");
  const Event& opened = fresh.events().front();
  ModelVersion in_file = versionOf(opened, fresh.base());
  const std::int64_t last_utc_ms = versions.back().utc_ms;
  const auto same = std::find_if(versions.rbegin(), versions.rend(),
                                 [&](const ModelVersion& version) { return version.sha256 == in_file.sha256; });
  const std::size_t known = versions.size();
  const bool changed_elsewhere = same == versions.rend();
  const std::size_t later = static_cast<std::size_t>(same - versions.rbegin());
  if (changed_elsewhere) {
    in_file.parent = versions.back().id;
    in_file.author = kElsewhere;
    in_file.label = std::string(name(EventKind::kEdit)) + ": " + changed_label;
    versions.push_back(std::move(in_file));
  }
  auto history = historyFrom(versions, ids, 0);
  if (!history) return tl::unexpected(std::move(history.error()));
  const auto last = history->modelOf(history->events()[known - 1].state);
  if (!last || !haveSameInputs(*last, fresh.base())) {
    return base::fail(base::ErrorCode::kMismatch, "the history", "a model with other inputs", "the inputs of the file");
  }
  EarlierHistory out{std::move(*history), known, {}, {}, 0, last_utc_ms, changed_elsewhere};
  if (changed_elsewhere || (later == 0 && !kept.unfinished)) return out;
  // The newest state is offered, and that of the file shown.
  out.lost = out.history.current();
  out.drag = std::move(kept.unfinished);
  out.edits = editsIn(std::span(versions).last(later)) + (out.drag ? 1 : 0);
  if (later > 0) {
    const StateId state = out.history.events()[known - 1 - later].state;
    if (auto back = out.history.returnTo(state, stamp); !back) return tl::unexpected(std::move(back.error()));
    out.kept = out.history.events().size();
  }
  return out;
}

}  // namespace tactus::editing
