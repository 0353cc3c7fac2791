// Bundles of the C interface.
#include <string>

#include "core/base/error.h"
#include "core/contracts/contract_check.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/bundle_check.h"
#include "core/runtime/message.h"

namespace tactus::runtime {
namespace {

/// The sentence about the first contract that the model breaks; empty where there is none.
std::string brokenContract(const fuzzy::ForceModel& model, const std::string& folder) {
  if (model.contracts.empty()) return {};
  const auto compiled = fuzzy::compile(model);
  if (!compiled) return compiled.error().message();
  for (const fuzzy::Contract& contract : model.contracts) {
    if (contracts::checkContract(model, *compiled, contract).verdict == contracts::Verdict::kViolated) {
      return folder + ": " + contracts::violationText(contracts::sentenceOf(model, contract));
    }
  }
  return {};
}

}  // namespace
}  // namespace tactus::runtime

using namespace tactus;  // NOLINT(google-build-using-namespace): the functions below are outside all namespaces
using namespace tactus::runtime;  // NOLINT(google-build-using-namespace)

tactus_status tactus_verify(const char* bundle_folder, double* largest_error_n, char* message, size_t message_size) {
  Message said(message, message_size);
  if (largest_error_n != nullptr) *largest_error_n = 0;
  if (bundle_folder == nullptr)
    return said.fail(TACTUS_BAD_ARGUMENT, "bundle_folder: found a null pointer, wanted the name of a folder");
  return guarded(said, [&] {
    const auto bundle = model_io::checkBundle(bundle_folder);
    if (!bundle) {
      const bool wrong = bundle.error().code == base::ErrorCode::kMismatch;
      return said.fail(wrong ? TACTUS_NOT_VERIFIED : TACTUS_BAD_FILE, bundle.error().message());
    }
    tactus_status status = TACTUS_OK;
    for (const model_io::FileCheck& file : bundle->files) {
      if (largest_error_n != nullptr && file.evaluated && file.largest_error_n > *largest_error_n)
        *largest_error_n = file.largest_error_n;
      if (!file.ok && status == TACTUS_OK) status = said.fail(TACTUS_NOT_VERIFIED, file.wrong);
    }
    if (status != TACTUS_OK) return status;
    const std::string broken = brokenContract(bundle->model, bundle_folder);
    if (!broken.empty()) status = said.fail(TACTUS_NOT_VERIFIED, broken);
    return status;
  });
}
