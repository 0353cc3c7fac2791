#include "core/exchange/dialect.h"

#include <algorithm>
#include <iterator>

#include "core/exchange/writers.h"

namespace tactus::exchange {
namespace {

struct Format {
  Dialect dialect;
  std::string_view name;
  std::string_view suffix;
  ReaderRule rule;
  base::Result<std::string> (*text)(const ExpertView& view);
};

template <auto write>
base::Result<std::string> textOf(const ExpertView& view) {
  return write(view);
}

/// In the order of the enumeration.
constexpr Format kFormats[] = {
    {Dialect::kFll, "fll", ".fll", {true, 1000, 1e-5}, textOf<fllText>},
    {Dialect::kFclIec, "fcl", ".iec.fcl", {false, 1000, 1e-3}, textOf<fclIecText>},
    {Dialect::kFclFuzzylite, "fcl-fuzzylite", ".fuzzylite.fcl", {true, 1000, 1e-5}, textOf<fclFuzzyliteText>},
    {Dialect::kFis, "fis", ".fis", {false, 101, 5e-3}, textOf<fisText>},
    {Dialect::kFml, "fml", ".fml", {false, 2000, 1e-3}, textOf<fmlText>},
};

constexpr const Format& formatOf(Dialect dialect) { return kFormats[static_cast<std::size_t>(dialect)]; }
static_assert(std::equal(std::begin(kFormats), std::end(kFormats), std::begin(kDialects), std::end(kDialects),
                         [](const Format& one, Dialect dialect) { return one.dialect == dialect; }));

}  // namespace

std::string_view name(Dialect dialect) noexcept { return formatOf(dialect).name; }
std::string_view suffix(Dialect dialect) noexcept { return formatOf(dialect).suffix; }
ReaderRule readerRule(Dialect dialect) noexcept { return formatOf(dialect).rule; }

base::Result<std::string> format(const fuzzy::ForceModel& model, std::size_t expert, Dialect dialect,
                                 const Origin& origin) {
  ExpertView view = viewOf(model, expert);
  view.origin = originText(origin);
  return formatOf(dialect).text(view);
}

}  // namespace tactus::exchange
