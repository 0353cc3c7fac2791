// Which format a file has, told from its content first.
#pragma once

#include <string>
#include <string_view>

#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {

/// An error for the bytes of formats that are known and not read: FML, JSON, MAT and compressed files.
base::Result<void> refuseOthers(std::string_view bytes, const std::string& file);

/// The format of the text, or an error where neither the content nor the extension tells.
base::Result<ImportFormat> guessFormat(const SourceText& source);

}  // namespace tactus::exchange
