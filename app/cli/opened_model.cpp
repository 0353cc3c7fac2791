#include "app/cli/opened_model.h"

#include <utility>

#include "core/model_io/model_file.h"

namespace tactus::cli {
namespace {

base::Result<OpenedModel> compiledOf(base::Result<model_io::ReadModel> read, const std::string& path) {
  if (!read) return tl::unexpected(std::move(read.error()));
  auto compiled = fuzzy::compile(read->model);
  if (!compiled) return base::inFile(std::move(compiled.error()), path);
  return OpenedModel{std::move(read->model), std::move(*compiled), std::move(read->warnings)};
}

}  // namespace

base::Result<OpenedModel> openedModel(const std::string& path) { return compiledOf(model_io::readModel(path), path); }

base::Result<OpenedModel> openedModel(std::string_view text, const std::string& path) {
  return compiledOf(model_io::parseModel(text, path), path);
}

}  // namespace tactus::cli
