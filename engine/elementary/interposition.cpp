/// Functions of <math.h> under their own names. Their versions in the C library give different results on
/// different processors, so every call in the process is bound to these functions. The linker binds the calls of
/// the program, because it finds these functions before the C library. The loader binds the calls of shared
/// libraries (GeographicLib, PROJ, NLopt, GDAL), because it searches the program first. For this the functions must
/// be in the program's dynamic symbol table: exported_names.txt.
/// The C library provides the functions with exact results (sqrt, fmod, floor) and the functions with only one
/// version (hypot, cbrt). Tests compare their bits with and without fused multiply-add. The complex functions of the
/// C library call its own real functions and not these, so std::pow, exp and log of complex numbers must not be used.

#include "engine/elementary/elementary.hpp"

namespace numbers = floeplan::elementary;

extern "C" {

double sin(double x) noexcept { return numbers::sin(x); }
double cos(double x) noexcept { return numbers::cos(x); }
double tan(double x) noexcept { return numbers::tan(x); }
// Compilers merge a sin and a cos of one argument into this call.
void sincos(double x, double* sine, double* cosine) noexcept {
  const numbers::SineCosine both = numbers::sincos(x);
  *sine = both.sine;
  *cosine = both.cosine;
}

double asin(double x) noexcept { return numbers::asin(x); }
double acos(double x) noexcept { return numbers::acos(x); }
double atan(double x) noexcept { return numbers::atan(x); }
double atan2(double y, double x) noexcept { return numbers::atan2(y, x); }

double exp(double x) noexcept { return numbers::exp(x); }
double exp2(double x) noexcept { return numbers::exp2(x); }
double expm1(double x) noexcept { return numbers::expm1(x); }
double pow(double x, double y) noexcept { return numbers::pow(x, y); }
double log(double x) noexcept { return numbers::log(x); }
double log2(double x) noexcept { return numbers::log2(x); }
double log10(double x) noexcept { return numbers::log10(x); }
double log1p(double x) noexcept { return numbers::log1p(x); }

double sinh(double x) noexcept { return numbers::sinh(x); }
double cosh(double x) noexcept { return numbers::cosh(x); }
double tanh(double x) noexcept { return numbers::tanh(x); }
double asinh(double x) noexcept { return numbers::asinh(x); }
double acosh(double x) noexcept { return numbers::acosh(x); }
double atanh(double x) noexcept { return numbers::atanh(x); }

}  // extern "C"
