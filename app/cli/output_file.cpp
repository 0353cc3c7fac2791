#include "app/cli/output_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/base/files/file.h"
#include "core/base/text.h"
#include "core/study/csv_tables.h"
#include "core/study/table_line.h"

namespace tactus::cli {
namespace {

namespace fs = std::filesystem;

/// Whether `out` may be read as a table of the study in `folder`, which also reads Speeds.CSV and speeds.txt.
bool isTableOf(const fs::path& folder, const fs::path& out) {
  std::error_code ignored;
  const fs::path parent = out.parent_path().empty() ? fs::path(".") : out.parent_path();
  const bool is_inside = fs::equivalent(folder, parent, ignored);
  const std::string stem = base::lowered(out.stem().string());
  const auto is_it = [&](std::string_view table) {
    return (is_inside && fs::path(table).stem() == stem) ||
           fs::equivalent(folder / study::publishedTable(table), out, ignored);
  };
  return std::ranges::any_of(std::array{study::kParticipantsTable, study::kSpeedsTable, study::kJudgementsTable,
                                        study::kAnswersTable, study::kRulesTable},
                             is_it);
}

}  // namespace

bool isDatabase(const std::string& path) {
  constexpr std::string_view kMagic{"SQLite format 3\0", 16};
  std::array<char, kMagic.size()> begin{};
  std::ifstream file(path, std::ios::binary);
  return file.read(begin.data(), begin.size()) && std::string_view(begin.data(), begin.size()) == kMagic;
}

base::Result<void> requireOutput(const std::string& out, const std::vector<std::string>& inputs) {
  std::error_code ignored;
  if (out.empty() || !fs::is_regular_file(out, ignored)) return {};
  const auto refused = [&out](const char* found) {
    return tl::unexpected(base::Error{base::ErrorCode::kValue, out, "--out", found, "another file"});
  };
  for (const std::string& input : inputs) {
    if (input.empty()) continue;
    const bool is_read = fs::is_directory(input, ignored) ? isTableOf(input, out) : fs::equivalent(input, out, ignored);
    if (is_read) return refused("a file that the command reads");
  }
  if (isDatabase(out)) return refused("a study file or another database");
  return {};
}

base::Result<Output> written(const std::string& out, std::string_view text, Output said, bool json) {
  if (out == "-") {
    if (json) {
      return base::fail(base::ErrorCode::kValue, "--out", "'-' beside --json",
                        "one of them, as both write to standard output");
    }
    return Output{std::string(text), std::move(said.warnings), true, std::move(said.failure)};
  }
  if (auto ok = base::writeFileAtomically(out, text); !ok) return tl::unexpected(ok.error());
  return said;
}

}  // namespace tactus::cli
