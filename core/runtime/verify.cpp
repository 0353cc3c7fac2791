// Bundles of the C interface.
#include "core/model_io/bundle_check.h"
#include "core/runtime/message.h"

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
    return status;
  });
}
