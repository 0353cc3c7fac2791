// The description that goes with exported tables: what each column holds, for programs (JSON) and people (Markdown).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/store/record_tables.h"

namespace tactus::session {

inline constexpr std::string_view kCodebookFormat = "tactus-study-export";

/// A codebook in the making: the tables in their order, with the names of their files below the folder.
struct Codebook {
  struct Table {
    std::string file;
    const store::RecordTable* table = nullptr;
  };
  bool shareable = false;
  std::vector<std::string> notes;  ///< one sentence each
  std::vector<Table> tables;
};

/// The five tables at the top of an export; `input_ids` are the inputs of rules.csv, which must outlive the result.
/// `shareable`: with the column of the bands of experience.
std::vector<store::RecordTable> viewTables(const std::vector<std::string>& input_ids, bool shareable);

std::string asJson(const Codebook& codebook);
std::string asMarkdown(const Codebook& codebook);

}  // namespace tactus::session
