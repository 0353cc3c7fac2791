#include "experiments/seeded_order.h"

namespace tactus::experiments {

std::uint64_t blockSeed(std::uint64_t seed, std::string_view block) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto take = [&hash](std::uint64_t byte) { hash = (hash ^ byte) * 0x100000001b3U; };
  for (int shift = 0; shift < 64; shift += 8) take((seed >> static_cast<unsigned>(shift)) & 0xffU);
  for (const char c : block) take(static_cast<unsigned char>(c));
  hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9U;
  hash = (hash ^ (hash >> 27U)) * 0x94d049bb133111ebU;
  return hash ^ (hash >> 31U);
}

}  // namespace tactus::experiments
