#include "app/workbench/model/template_model.h"

#include <QDir>
#include <utility>

#include "app/workbench/model/fresh_path.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::workbench {

base::Result<OpenModel> ngtTemplateModel(const QString& name, const QString& folder) {
  fuzzy::ForceModel model;
  model.name = name.toStdString();
  model.inputs = elicitation::ngtInputs();
  model.output = elicitation::ngtOutput();
  fuzzy::Expert expert;
  expert.id = expert.label = "E1";
  model.experts.push_back(std::move(expert));
  auto ready = editing::ready(std::move(model));
  if (!ready) return tl::unexpected(ready.error());
  OpenModel open(std::move(*ready));
  open.path = freshModelPath(QDir(folder).absoluteFilePath(QStringLiteral("ngt")));
  return open;
}

}  // namespace tactus::workbench
