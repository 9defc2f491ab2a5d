/// Prints a line for each function: its name and a digest of the bits of its values for a hundred thousand arguments. Two
/// runs print the same where the function does not depend on the processor. Those with "libm" are the C library's own.

#include <dlfcn.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

namespace {

using One = double (*)(double);
using Two = double (*)(double, double);

constexpr int arguments = 100000;

/// An argument of either sign whose size lies between 2^-30 and 2^10, mostly about one.
double argument(std::mt19937_64& rng) {
  const auto uniform = [&rng] { return static_cast<double>(rng() >> 11) * 0x1p-53; };
  if (rng() % 2 == 0) return 4.0 * uniform() - 2.0;
  return std::ldexp(1.0 + uniform(), static_cast<int>(rng() % 40) - 30) * (rng() % 2 == 0 ? 1.0 : -1.0);
}

class Digest {
 public:
  void add(double value) {  // FNV-1a by whole words
    const std::uint64_t bits = std::isnan(value) ? 1 : std::bit_cast<std::uint64_t>(value);
    state_ = (state_ ^ bits) * 0x100000001b3;
    state_ ^= state_ >> 29;
  }
  void print(const char* name) const {
    std::printf("%s %016llx\n", name, static_cast<unsigned long long>(state_));
  }

 private:
  std::uint64_t state_{0xcbf29ce484222325};
};

void digest(const char* name, One function) {
  std::mt19937_64 rng{1};
  Digest result;
  for (int i = 0; i < arguments; ++i) result.add(function(argument(rng)));
  result.print(name);
}

void digest(const char* name, Two function) {
  std::mt19937_64 rng{2};
  Digest result;
  for (int i = 0; i < arguments; ++i) {
    const double x = argument(rng);
    result.add(function(x, argument(rng)));
  }
  result.print(name);
}

}  // namespace

int main() {
  digest("sin", static_cast<One>(std::sin));
  digest("cos", static_cast<One>(std::cos));
  digest("tan", static_cast<One>(std::tan));
  digest("asin", static_cast<One>(std::asin));
  digest("acos", static_cast<One>(std::acos));
  digest("atan", static_cast<One>(std::atan));
  digest("atan2", static_cast<Two>(std::atan2));
  digest("exp", static_cast<One>(std::exp));
  digest("exp2", static_cast<One>(std::exp2));
  digest("expm1", static_cast<One>(std::expm1));
  digest("pow", static_cast<Two>(std::pow));
  digest("log", static_cast<One>(std::log));
  digest("log2", static_cast<One>(std::log2));
  digest("log10", static_cast<One>(std::log10));
  digest("log1p", static_cast<One>(std::log1p));
  digest("sinh", static_cast<One>(std::sinh));
  digest("cosh", static_cast<One>(std::cosh));
  digest("tanh", static_cast<One>(std::tanh));
  digest("asinh", static_cast<One>(std::asinh));
  digest("acosh", static_cast<One>(std::acosh));
  digest("atanh", static_cast<One>(std::atanh));

  digest("cbrt", static_cast<One>(std::cbrt));
  digest("hypot", static_cast<Two>(std::hypot));
  digest("fmod", static_cast<Two>(std::fmod));
  digest("remainder", static_cast<Two>(std::remainder));
  digest("sqrt", static_cast<One>(std::sqrt));
  digest("rint", static_cast<One>(std::rint));
  digest("hypotf", [](double x, double y) -> double {
    return std::hypot(static_cast<float>(x), static_cast<float>(y));
  });

  void* const libm = dlopen("libm.so.6", RTLD_NOW);
  if (libm == nullptr) return 1;
  digest("libm:sin", std::bit_cast<One>(dlsym(libm, "sin")));
  digest("libm:atan2", std::bit_cast<Two>(dlsym(libm, "atan2")));
}
