// The source of the loops. Only fcm_kernels.cpp includes it: once per instruction set, each time in another namespace
// and for another target. The samples of a block are distributed over kFcmLanes lanes. A register holds some of the
// lanes; the loop runs once for each register's share.

#include "elicitation/clustering/fcm_register_source.h"

/// The contribution of one sample besides its distances, before its weight.
struct Shares {
  Register h;
  Register least;  // of what must not underflow
};

/// A row: as many samples as there are lanes.
TACTUS_INLINE int rowsOf(const FcmBlock& block) noexcept { return static_cast<int>(block.count / kFcmLanes); }

TACTUS_INLINE Register weights(const FcmBlock& block, int share, int row) noexcept {
  return load(block.weights + row * static_cast<int>(kFcmLanes) + share * kWidth) * block.weight_scale;
}

/// The distances of the samples of one share and row from the centers.
template <int count>
TACTUS_INLINE void distances(const FcmBlock& block, const FcmPlace& place, int share, int row, Register* d) noexcept {
  const int c = count > 0 ? count : static_cast<int>(place.clusters);
  const double* const from = block.values + row * static_cast<int>(kFcmLanes) + share * kWidth;
  const Register x = (load(from) * block.scale - block.shift) * block.stretch;
#pragma GCC unroll 4
  for (int k = 0; k < c; ++k) d[k] = x - place.centres[k];
}

/// u^m by products of squared distances, m = 2.
template <int count>
TACTUS_INLINE Shares byProducts(const Register* d, Register* power, int clusters) noexcept {
  const int c = count > 0 ? count : clusters;
  Register before = spread(1.0);
#pragma GCC unroll 4
  for (int k = 0; k < c; ++k) {
    power[k] = before;
    before *= d[k] * d[k];
  }
  Register after = spread(1.0);
  Register sum{};
#pragma GCC unroll 4
  for (int k = c - 1; k >= 0; --k) {
    power[k] *= after;
    after *= d[k] * d[k];
    sum += power[k];
  }
  const Register scale = 1.0 / sum;
#pragma GCC unroll 4
  for (int k = 0; k < c; ++k) {
    const Register u = power[k] * scale;
    power[k] = u * u;
  }
  return {before * scale, sum};
}

/// u^m by ratios: r_k = (q_min / q_k)^p with q = d^2 and p = 1 / (m - 1); with S their sum u_k^m = r_k^m / S^m and
/// r_k^m = r_k q_min / q_k. Here r_k^m of all centers and S. The nearest center has r = 1 and needs no power.
template <int count, bool two>
TACTUS_INLINE Register ratiosOf(const Register* d, Register* ratio_m, int clusters, double m) noexcept {
  constexpr int kRoom = count > 0 ? count : static_cast<int>(kMostClusters);
  const int c = count > 0 ? count : clusters;
  Register nearest = spread(__builtin_inf());
#pragma GCC unroll 4
  for (int k = 0; k < c; ++k) nearest = smaller(d[k] * d[k], nearest);
  // others[1] to others[c - 1]: the centers without the first nearest one. passed[k]: that one is among 0 to k.
  Choice passed[kRoom];
  Register others[kRoom];
  Register sum = spread(1.0);
  Choice past{};
#pragma GCC unroll 4
  for (int k = 0; k < c; ++k) {
    const Choice before = past;
    past |= d[k] * d[k] == nearest;
    passed[k] = past;
    if (k == 0) continue;
    const Register farther = before ? d[k] : d[k - 1];
    const Register q = farther * farther;
    const Register ratio = q == nearest ? spread(1.0) : nearest / q;
    Register r = ratio;
    if constexpr (!two) {
      r = ratio > 0.0 ? powerOfTwo(logarithm(larger(ratio, spread(1e-300))) * (1 / (m - 1))) : Register{};
    }
    sum += r;
    others[k] = r * ratio;
  }
#pragma GCC unroll 4
  for (int k = 0; k < c; ++k) {
    ratio_m[k] = k + 1 < c ? (passed[k] ? spread(1.0) : others[k + 1]) : spread(1.0);
    if (k > 0) ratio_m[k] = passed[k - 1] ? others[k] : ratio_m[k];
  }
  return sum;
}

/// What the powers of the samples of one share need, computed in two short loops: so the processor has the powers of
/// several registers under way, none of which waits for another.
template <int count, bool two>
struct Ratios {
  static constexpr int kRoom = count > 0 ? count : static_cast<int>(kMostClusters);
  Register ratio_m[kFcmMostRows * kRoom];
  Register sum[kFcmMostRows];
  Register scale[kFcmMostRows];
  int clusters;

  TACTUS_INLINE void fill(const FcmBlock& block, const FcmPlace& place, int share) noexcept {
    const int c = count > 0 ? count : static_cast<int>(place.clusters);
    const double m = place.m;
    clusters = c;
    const int rows = rowsOf(block);
    for (int row = 0; row < rows; ++row) {
      Register d[kRoom];
      distances<count>(block, place, share, row, d);
      sum[row] = ratiosOf<count, two>(d, ratio_m + row * c, c, m);
    }
    for (int row = 0; row < rows; ++row) {
      scale[row] = two ? 1.0 / (sum[row] * sum[row]) : powerOfTwo(logarithm(sum[row]) * -m);
    }
  }
  TACTUS_INLINE Shares operator()(int row, const Register* d, Register* power) const noexcept {
    const int c = count > 0 ? count : clusters;
    Register nearest = spread(__builtin_inf());
#pragma GCC unroll 4
    for (int k = 0; k < c; ++k) {
      power[k] = ratio_m[row * c + k] * scale[row];
      nearest = smaller(d[k] * d[k], nearest);
    }
    return {nearest * sum[row] * scale[row], spread(1.0)};
  }
};

/// On a center every u^m d is 0, but (u^m d)^2 / h tends to u^m. Adds this limit to the diagonal of the products, for
/// the samples of one share that lie on a center. Without it, a center on a single sample has a negative curvature, and
/// Newton's step is impossible.
template <class Powers>
void addOnCentres(const FcmBlock& block, const FcmPlace& place, int share, Register* outer,
                  const Powers& powers) noexcept {
  const int c = static_cast<int>(place.clusters);
  for (int row = 0; row < rowsOf(block); ++row) {
    Register d[kMostClusters], power[kMostClusters];
    distances<0>(block, place, share, row, d);
    const Shares of = powers(row, d, power);
    const Register weight = block.weights == nullptr ? spread(1.0) : weights(block, share, row);
    const Register on_centre = of.h > 0.0 ? Register{} : weight;
    for (int k = 0, diagonal = 0; k < c; ++k, diagonal += k + 1) outer[diagonal] += on_centre * power[k];
  }
}

/// Adds the samples of one share. `count`: the number of clusters if known at compile time, else 0.
template <int count, class Powers>
TACTUS_INLINE Register addShare(const FcmBlock& block, const FcmPlace& place, int share, double* sums,
                                const Powers& powers) noexcept {
  constexpr int kRoom = count > 0 ? count : static_cast<int>(kMostClusters);
  const int c = count > 0 ? count : static_cast<int>(place.clusters);
  const int sum_count = static_cast<int>(fcmSumCount(static_cast<std::size_t>(c)));
  Register total[fcmSumCount(kRoom)];
  for (int j = 0; j < sum_count; ++j) total[j] = Register{};
  Register least = spread(1.0);
  Register lowest = spread(1.0);  // of h
  for (int row = 0; row < rowsOf(block); ++row) {
    Register d[kRoom], power[kRoom];
    distances<count>(block, place, share, row, d);
    const Shares of = powers(row, d, power);
    least = smaller(of.least, least);
    lowest = smaller(of.h, lowest);
    Register factor = 1.0 / larger(of.h, spread(1e-300));
    Register h = of.h;
    Register weight = spread(1.0);
    if (block.weights != nullptr) {
      weight = weights(block, share, row);
      factor *= weight;
      h *= weight;
    }
    Register* outer = total + 2 * c;
#pragma GCC unroll 4
    for (int k = 0; k < c; ++k) {
      const Register pull = power[k] * d[k];
      total[k] += weight * power[k];
      total[c + k] += weight * pull;
      d[k] = pull;
      const Register scaled = pull * factor;
#pragma GCC unroll 4
      for (int l = 0; l <= k; ++l) *outer++ += scaled * d[l];
    }
    *outer += h;
  }
  bool on_centre = false;
  for (int lane = 0; lane < kWidth; ++lane) on_centre = on_centre || !(lowest[lane] > 0);
  if (on_centre) addOnCentres(block, place, share, total + 2 * c, powers);
  for (int j = 0; j < sum_count; ++j) store(sums + j * static_cast<int>(kFcmLanes) + share * kWidth, total[j]);
  return least;
}

template <int count>
bool productSums(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept {
  const int c = static_cast<int>(place.clusters);
  bool fine = true;
  for (int share = 0; share < kShares; ++share) {
    const auto powers = [c](int, const Register* d, Register* power)
                            TACTUS_INLINED { return byProducts<count>(d, power, c); };
    const Register least = addShare<count>(block, place, share, sums, powers);
    for (int lane = 0; lane < kWidth; ++lane) fine = fine && least[lane] >= kSmallestProduct;
  }
  return fine;
}

bool products(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept {
  switch (place.clusters) {
    case 2: return productSums<2>(block, place, sums);
    case 3: return productSums<3>(block, place, sums);
    case 4: return productSums<4>(block, place, sums);
    default: return productSums<0>(block, place, sums);
  }
}

template <int count, bool two>
void ratioSums(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept {
  Ratios<count, two> powers;
  for (int share = 0; share < kShares; ++share) {
    powers.fill(block, place, share);
    addShare<count>(block, place, share, sums, powers);
  }
}

template <int count>
void ratioSums(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept {
  return place.m == 2 ? ratioSums<count, true>(block, place, sums) : ratioSums<count, false>(block, place, sums);
}

void ratios(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept {
  switch (place.clusters) {
    case 2: return ratioSums<2>(block, place, sums);
    case 3: return ratioSums<3>(block, place, sums);
    case 4: return ratioSums<4>(block, place, sums);
    default: return ratioSums<0>(block, place, sums);
  }
}

#undef TACTUS_INLINED
#undef TACTUS_INLINE
#undef TACTUS_FCM_WIDTH
