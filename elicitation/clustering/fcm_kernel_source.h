// The source of the loops. Only fcm_kernels.cpp includes it: once per instruction set, each time in another namespace
// and for another target. The samples of a block are distributed over kFcmLanes lanes. A register holds some of the
// lanes; the loop runs once for each register's share.

constexpr int kWidth = TACTUS_FCM_WIDTH;
constexpr int kShares = static_cast<int>(kFcmLanes) / kWidth;
using Register = double __attribute__((vector_size(kWidth * sizeof(double)), may_alias));
using Bits = long long __attribute__((vector_size(kWidth * sizeof(double))));

#define TACTUS_INLINE [[gnu::always_inline]] inline

TACTUS_INLINE Register spread(double x) noexcept { return Register{} + x; }
TACTUS_INLINE Register load(const double* from) noexcept {
  Register r;
  __builtin_memcpy(&r, from, sizeof r);
  return r;
}
TACTUS_INLINE void store(double* to, const Register& x) noexcept { __builtin_memcpy(to, &x, sizeof x); }
TACTUS_INLINE Register smaller(const Register& x, const Register& y) noexcept { return x < y ? x : y; }
TACTUS_INLINE Register larger(const Register& x, const Register& y) noexcept { return x > y ? x : y; }

// ln 2 in two parts. The first has trailing zeros, so that its products with exponents are exact.
constexpr double kLn2High = 0x1.62e42fefa38p-1;
constexpr double kLn2Low = 0x1.ef35793c7673p-45;
constexpr double kRoundToInteger = 0x1.8p52;

/// Natural logarithm of a positive normal number: exponent and 2 artanh((f - 1)/(f + 1)) of a mantissa f around 1.
TACTUS_INLINE Register logarithm(const Register& x) noexcept {
  Bits bits;
  __builtin_memcpy(&bits, &x, sizeof bits);
  const Bits shifted = bits - 0x3FE6A09E667F3BCDLL;  // of the square root of 1/2
  const Bits exponent = shifted >> 52;
  const Bits mantissa = bits - (exponent << 52);
  Register f;
  __builtin_memcpy(&f, &mantissa, sizeof f);
  const Register s = (f - 1.0) / (f + 1.0);
  const Register z = s * s;
  Register series = spread(1.0 / 21);
#pragma GCC unroll 16
  for (int k = 19; k >= 3; k -= 2) series = series * z + 1.0 / k;
  const Register e = __builtin_convertvector(exponent, Register);
  return e * kLn2High + (2.0 * s + (2.0 * s * z * series + e * kLn2Low));
}

/// e^x for x <= 0; 0 below -700.
TACTUS_INLINE Register exponential(const Register& x) noexcept {
  const Register safe = larger(x, spread(-700.0));
  const Register turns = safe * 0x1.71547652b82fep0 + kRoundToInteger;
  const Register k = turns - kRoundToInteger;
  const Register t = (safe - k * kLn2High) - k * kLn2Low;
  Register series = spread(1.0);
#pragma GCC unroll 16
  for (int n = 13; n >= 1; --n) series = series * t * (1.0 / n) + 1.0;
  Bits bits, steps;
  __builtin_memcpy(&bits, &series, sizeof bits);
  __builtin_memcpy(&steps, &turns, sizeof steps);
  bits += steps << 52;  // the low bits of `turns` are the integer
  Register out;
  __builtin_memcpy(&out, &bits, sizeof out);
  return x < -700.0 ? Register{} : out;
}

/// The contribution of one sample besides its distances, before its weight.
struct Shares {
  Register h;
  Register least;  // of what must not underflow
};

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
/// r_k^m = r_k q_min / q_k.
template <bool two>
TACTUS_INLINE Shares byRatios(const Register* d, Register* power, int c, double m) noexcept {
  Register nearest = spread(__builtin_inf());
  for (int k = 0; k < c; ++k) nearest = smaller(d[k] * d[k], nearest);
  Register sum{};
  for (int k = 0; k < c; ++k) {
    const Register q = d[k] * d[k];
    const Register ratio = q == nearest ? spread(1.0) : nearest / q;
    Register r = ratio;
    if constexpr (!two) {
      r = ratio > 0 ? exponential(logarithm(larger(ratio, spread(1e-300))) * (1 / (m - 1))) : Register{};
    }
    sum += r;
    power[k] = r * ratio;
  }
  const Register scale = two ? 1.0 / (sum * sum) : exponential(logarithm(sum) * -m);
  for (int k = 0; k < c; ++k) power[k] *= scale;
  return {nearest * sum * scale, spread(1.0)};
}

/// On a center every u^m d is 0, but (u^m d)^2 / h tends to u^m. Adds this limit to the diagonal of the products, for
/// the samples of one share that lie on a center. Without it, a center on a single sample has a negative curvature, and
/// Newton's step is impossible.
template <class Powers>
void addOnCentres(const FcmBlock& block, const FcmPlace& place, int share, Register* outer, Powers powers) noexcept {
  const int c = static_cast<int>(place.clusters);
  for (std::size_t i = static_cast<std::size_t>(share) * kWidth; i < block.count; i += kFcmLanes) {
    const Register x = (load(block.values + i) * block.scale - block.shift) * block.stretch;
    Register d[kMostClusters], power[kMostClusters];
    for (int k = 0; k < c; ++k) d[k] = x - place.centres[k];
    const Shares of = powers(d, power);
    const Register weight = block.weights == nullptr ? spread(1.0) : load(block.weights + i) * block.weight_scale;
    const Register on_centre = of.h > 0.0 ? Register{} : weight;
    for (int k = 0, diagonal = 0; k < c; ++k, diagonal += k + 1) outer[diagonal] += on_centre * power[k];
  }
}

/// Adds the samples of one share. `count`: the number of clusters if known at compile time, else 0.
template <int count, class Powers>
TACTUS_INLINE Register addShare(const FcmBlock& block, const FcmPlace& place, int share, double* sums,
                                Powers powers) noexcept {
  constexpr int kRoom = count > 0 ? count : static_cast<int>(kMostClusters);
  const int c = count > 0 ? count : static_cast<int>(place.clusters);
  const int sum_count = static_cast<int>(fcmSumCount(static_cast<std::size_t>(c)));
  Register total[fcmSumCount(kRoom)];
  for (int j = 0; j < sum_count; ++j) total[j] = Register{};
  Register least = spread(1.0);
  Register lowest = spread(1.0);  // of h
  for (std::size_t i = static_cast<std::size_t>(share) * kWidth; i < block.count; i += kFcmLanes) {
    const Register x = (load(block.values + i) * block.scale - block.shift) * block.stretch;
    Register d[kRoom], power[kRoom];
#pragma GCC unroll 4
    for (int k = 0; k < c; ++k) d[k] = x - place.centres[k];
    const Shares of = powers(d, power);
    least = smaller(of.least, least);
    lowest = smaller(of.h, lowest);
    Register factor = 1.0 / larger(of.h, spread(1e-300));
    Register h = of.h;
    Register weight = spread(1.0);
    if (block.weights != nullptr) {
      weight = load(block.weights + i) * block.weight_scale;
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
    const Register least = addShare<count>(
        block, place, share, sums, [c](const Register* d, Register* power) { return byProducts<count>(d, power, c); });
    for (int lane = 0; lane < kWidth; ++lane) fine = fine && least[lane] >= kSmallestProduct;
  }
  return fine;
}

bool products(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept {
  switch (place.clusters) {
    case 2:
      return productSums<2>(block, place, sums);
    case 3:
      return productSums<3>(block, place, sums);
    case 4:
      return productSums<4>(block, place, sums);
    default:
      return productSums<0>(block, place, sums);
  }
}

void ratios(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept {
  const int c = static_cast<int>(place.clusters);
  const double m = place.m;
  for (int share = 0; share < kShares; ++share) {
    if (m == 2) {
      addShare<0>(block, place, share, sums,
                  [c, m](const Register* d, Register* power) { return byRatios<true>(d, power, c, m); });
    } else {
      addShare<0>(block, place, share, sums,
                  [c, m](const Register* d, Register* power) { return byRatios<false>(d, power, c, m); });
    }
  }
}

#undef TACTUS_INLINE
#undef TACTUS_FCM_WIDTH
