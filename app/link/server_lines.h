// What the server of the live link says: each function gives one line of JSON with its line end.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/link/link_state.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::link {

/// `program`: name and version of the server.
std::string helloLine(std::string_view program);

/// `text`: of a valid model file. `file` in the line is that text without white space between tokens and the last
/// member, so that a client without a JSON reader can cut it out. `sha256` is of `text`, as `sha256sum` gives for the
/// file; `sent_sha256` is of the bytes of `file` in this line.
std::string modelLine(std::uint64_t serial, std::string_view sha256, std::string_view text);

std::string stateLine(const LinkState& state, const LinkSetting& setting);

/// `id`: JSON text. `serial`: of the model that answers.
std::string answerLine(std::string_view id, const fuzzy::Evaluation& force, std::uint64_t serial);

std::string errorLine(std::string_view sentence);

}  // namespace tactus::link
