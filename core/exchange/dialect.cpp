#include "core/exchange/dialect.h"

#include "core/exchange/writers.h"

namespace tactus::exchange {

std::string_view name(Dialect dialect) noexcept {
  constexpr std::string_view kNames[] = {"fll", "fcl", "fcl-fuzzylite", "fis", "fml"};
  return kNames[static_cast<int>(dialect)];
}

std::string_view suffix(Dialect dialect) noexcept {
  constexpr std::string_view kSuffixes[] = {".fll", ".iec.fcl", ".fuzzylite.fcl", ".fis", ".fml"};
  return kSuffixes[static_cast<int>(dialect)];
}

ReaderRule readerRule(Dialect dialect) noexcept {
  switch (dialect) {
    case Dialect::kFll:
    case Dialect::kFclFuzzylite: return {true, 1000, 1e-5};
    case Dialect::kFclIec: return {false, 1000, 1e-3};
    case Dialect::kFis: return {false, 101, 5e-3};
    case Dialect::kFml: return {false, 2000, 1e-3};
  }
  return {true, 1000, 1e-5};
}

base::Result<std::string> format(const fuzzy::ForceModel& model, std::size_t expert, Dialect dialect,
                                 const Origin& origin) {
  ExpertView view = viewOf(model, expert);
  view.origin = originText(origin);
  switch (dialect) {
    case Dialect::kFll: return fllText(view);
    case Dialect::kFclIec: return fclIecText(view);
    case Dialect::kFclFuzzylite: return fclFuzzyliteText(view);
    case Dialect::kFis: return fisText(view);
    case Dialect::kFml: return fmlText(view);
  }
  return base::fail(base::ErrorCode::kValue, "format", "an unknown one", "one of those of this version");
}

}  // namespace tactus::exchange
