#include "app/cli/pull_sign_offs.h"

#include "app/cli/study_text.h"
#include "app/editing/edit_history.h"
#include "core/model_io/model_file.h"
#include "core/store/model_versions.h"

namespace tactus::cli {
namespace {

/// `model` without what does not change its force.
fuzzy::ForceModel forceAlone(fuzzy::ForceModel model) {
  model.created_utc.clear();
  model.generator.clear();
  model.provenance.reset();
  model.checks.clear();
  return model;
}

}  // namespace

base::Result<std::vector<SignOff>> signOffsOn(fuzzy::ForceModel model, const std::string& path) {
  const auto file = store::StudyFile::open(path, {store::Access::kReadOnly});
  if (!file) return tl::unexpected(file.error());
  const auto versions = store::modelVersions(*file);
  if (!versions) return base::inFile(versions.error(), path);
  model = forceAlone(std::move(model));
  const std::string start = std::string(name(editing::EventKind::kSignOff)) + ": ";
  std::vector<SignOff> out;
  for (const study::ModelVersion& version : *versions) {
    if (!version.label.starts_with(start)) continue;
    const auto whole = store::modelVersion(*file, version.id);
    if (!whole) return base::inFile(whole.error(), path);
    auto signed_off = model_io::parseModel(whole->text, path + ": model version " + study::toText(version.id));
    if (!signed_off) return tl::unexpected(signed_off.error());
    if (forceAlone(std::move(signed_off->model)) != model) continue;
    out.push_back({version.author, version.label.substr(start.size()), utcText(version.utc_ms)});
  }
  return out;
}

}  // namespace tactus::cli
