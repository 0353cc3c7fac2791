// fuzzylite as a contender.
#include "core/base/check.h"

#include "tests/bench/contenders.h"
#include "tests/bench/fuzzylite_peer.h"

namespace tactus::bench {

std::optional<Contender> fuzzylite(const Case& about, int resolution) {
  TACTUS_CHECK(about.model.experts.size() == 1);
  PeerEvaluator peer = fuzzylitePeer(about.model, resolution);
  if (!peer) return std::nullopt;
  const std::span<const double> rows = about.points.rows;
  auto run = [peer = std::move(peer), rows, width = about.points.inputs](std::size_t first, std::span<double> out) {
    peer(rows.subspan(first * width, out.size() * width), out);
  };
  return Contender{"fuzzylite",
                   resolution,
                   &about,
                   {about.name + ": fuzzylite, resolution " + std::to_string(resolution), about.points.count(), run}};
}

}  // namespace tactus::bench
