// The readers of the three formats. Nothing outside this folder includes this; `importModel` (import_model.h) does.
#pragma once

#include <memory>

#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {

/// Reads a text completely. An error has line and column: what was found, and what was wanted. What the text says but
/// Tactus need not know becomes a warning of `source`.
base::Result<ForeignModel> readFll(const std::shared_ptr<SourceText>& source);
base::Result<ForeignModel> readFcl(const std::shared_ptr<SourceText>& source);
base::Result<ForeignModel> readFis(const std::shared_ptr<SourceText>& source);

}  // namespace tactus::exchange
