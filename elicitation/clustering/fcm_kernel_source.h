// The source of the loops. Only fcm_kernels.cpp includes it: once per instruction set, each time in another namespace
// and for another target. The samples of a block are distributed over kFcmLanes lanes. A register holds some of the
// lanes; the loop runs once for each register's share.

// Registers of the loops, and their logarithms and powers.

constexpr int kWidth = TACTUS_FCM_WIDTH;
constexpr int kShares = static_cast<int>(kFcmLanes) / kWidth;
using Register = double __attribute__((vector_size(kWidth * sizeof(double)), may_alias));
using Bits = unsigned long long __attribute__((vector_size(kWidth * sizeof(double))));
using Choice = long long __attribute__((vector_size(kWidth * sizeof(double))));  // of a comparison

#define TACTUS_INLINE [[gnu::always_inline]] inline
#define TACTUS_INLINED __attribute__((always_inline))  // of a lambda

TACTUS_INLINE Register spread(double x) noexcept { return Register{} + x; }
TACTUS_INLINE Register load(const double* from) noexcept {
  Register r;
  __builtin_memcpy(&r, from, sizeof r);
  return r;
}
TACTUS_INLINE void store(double* to, const Register& x) noexcept { __builtin_memcpy(to, &x, sizeof x); }
TACTUS_INLINE Register smaller(const Register& x, const Register& y) noexcept { return x < y ? x : y; }
TACTUS_INLINE Register larger(const Register& x, const Register& y) noexcept { return x > y ? x : y; }

constexpr double kRoundToInteger = 0x1.8p52;

/// c[0] + c[1] x + ... of two chains of half the length, which a processor computes side by side.
template <int count>
TACTUS_INLINE Register polynomial(const double (&c)[count], const Register& x) noexcept {
  const Register square = x * x;
  Register even = spread(c[(count - 1) / 2 * 2]);
  Register odd = spread(c[count / 2 * 2 - 1]);
#pragma GCC unroll 16
  for (int n = (count - 1) / 2 * 2 - 2; n >= 0; n -= 2) even = even * square + c[n];
#pragma GCC unroll 16
  for (int n = count / 2 * 2 - 3; n >= 1; n -= 2) odd = odd * square + c[n];
  return even + x * odd;
}

/// Logarithm to base 2 of a positive normal number: exponent and 2/ln 2 artanh((f - 1)/(f + 1)) of a mantissa f around
/// 1. The polynomial has the smallest largest error (Remez), 2.3e-18 of the result.
TACTUS_INLINE Register logarithm(const Register& x) noexcept {
  constexpr double kSeries[] = {0x1.ec709dc3a0435p-1, 0x1.2776c50eea858p-1, 0x1.a61762cecb807p-2, 0x1.484afd738c535p-2,
                                0x1.0ca125f770604p-2, 0x1.c472ede3fdc95p-3, 0x1.b59894815afc3p-3};
  constexpr unsigned long long kRootOfHalf = 0x3FE6A09E667F3BCDULL;
  constexpr unsigned long long kPositive = 1ULL << 63U;  // keeps what is shifted above 0
  Bits bits;
  __builtin_memcpy(&bits, &x, sizeof bits);
  const Bits shifted = (bits - kRootOfHalf + kPositive) >> 52U;  // the exponent + 2048
  const Bits mantissa = bits - ((shifted << 52U) - kPositive);
  const Bits counted = shifted + 0x4330000000000000ULL;  // as a double: 2^52 + 2048 + the exponent
  Register f, e;
  __builtin_memcpy(&f, &mantissa, sizeof f);
  __builtin_memcpy(&e, &counted, sizeof e);
  e -= 0x1p52 + 2048;
  const Register s = (f - 1.0) / (f + 1.0);
  const Register z = s * s;
  return e + (s * 0x1.71547652b82fep+1 + s * z * polynomial(kSeries, z));
}

/// 2^x for x <= 0; 0 below -1000. The polynomial for -1/2 to 1/2 is Remez's too, with an error of 3.4e-18.
TACTUS_INLINE Register powerOfTwo(const Register& x) noexcept {
  constexpr double kSeries[] = {0x1.62e42fefa39efp-1,  0x1.ebfbdff82c5a4p-3,  0x1.c6b08d7049fe8p-5,
                                0x1.3b2ab6fba011ap-7,  0x1.5d87fe78cd6d1p-10, 0x1.4309130ed8a6dp-13,
                                0x1.ffcbfba97f8afp-17, 0x1.62bfc79daa310p-20, 0x1.b5267ce43d1bbp-24,
                                0x1.e61b4efb4d864p-28, 0x1.e79baed8df3bdp-32};
  const Register safe = larger(x, spread(-1000.0));
  const Register turns = safe + kRoundToInteger;
  const Register t = safe - (turns - kRoundToInteger);
  Register out = t * polynomial(kSeries, t) + 1.0;
  Bits bits, steps;
  __builtin_memcpy(&bits, &out, sizeof bits);
  __builtin_memcpy(&steps, &turns, sizeof steps);
  bits += steps << 52U;  // the low bits of `turns` are the integer
  __builtin_memcpy(&out, &bits, sizeof out);
  return x < -1000.0 ? Register{} : out;
}

// The loops.

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
