// The codebook of exported tables: the contents of each column, for programs (JSON) and people (Markdown).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/store/record_tables.h"

namespace tactus::session {

inline constexpr std::string_view kCodebookFormat = "tactus-study-export";

/// A codebook under construction: the tables in order, with their file names below the folder.
struct Codebook {
  struct Table {
    std::string file;
    const store::RecordTable* table = nullptr;
  };
  bool shareable = false;
  std::vector<std::string> notes;  ///< one sentence each
  std::vector<Table> tables;
};

/// The five tables at the top of an export. `input_ids`: the inputs in rules.csv; they must outlive the result.
/// `shareable`: with the column of experience bands.
std::vector<store::RecordTable> viewTables(const std::vector<std::string>& input_ids, bool shareable);

std::string asJson(const Codebook& codebook);
std::string asMarkdown(const Codebook& codebook);

}  // namespace tactus::session
