#include "questionnaires/item_order.h"

#include <numeric>
#include <utility>

#include "core/base/random.h"

namespace tactus::questionnaires {

std::string_view name(ItemOrder order) noexcept { return order == ItemOrder::kFixed ? "fixed" : "shuffled"; }

std::vector<std::size_t> itemOrder(std::size_t count, ItemOrder order, std::uint64_t seed) {
  std::vector<std::size_t> places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  if (order == ItemOrder::kFixed) return places;
  base::Random random(seed);
  for (std::size_t left = count; left > 1; --left) {
    std::swap(places[left - 1], places[static_cast<std::size_t>(random.below(static_cast<int>(left)))]);
  }
  return places;
}

}  // namespace tactus::questionnaires
