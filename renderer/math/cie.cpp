#include "renderer/math/cie.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/math/colour.h"

namespace candela {
namespace {

// [CIE15], tables T.4 and T.1, every 10 nm from 380 to 780.
constexpr double first_wavelength = 380;
constexpr double step = 10;
struct Row {
  double x, y, z;  // colour matching functions
  double d65;      // the standard illuminant
};
constexpr std::array<Row, 41> rows{{
    {0.0014, 0.0000, 0.0065, 49.98},  {0.0042, 0.0001, 0.0201, 54.65},
    {0.0143, 0.0004, 0.0679, 82.75},  {0.0435, 0.0012, 0.2074, 91.49},
    {0.1344, 0.0040, 0.6456, 93.43},  {0.2839, 0.0116, 1.3856, 86.68},
    {0.3483, 0.0230, 1.7471, 104.86}, {0.3362, 0.0380, 1.7721, 117.01},
    {0.2908, 0.0600, 1.6692, 117.81}, {0.1954, 0.0910, 1.2876, 114.86},
    {0.0956, 0.1390, 0.8130, 115.92}, {0.0320, 0.2080, 0.4652, 108.81},
    {0.0049, 0.3230, 0.2720, 109.35}, {0.0093, 0.5030, 0.1582, 107.80},
    {0.0633, 0.7100, 0.0782, 104.79}, {0.1655, 0.8620, 0.0422, 107.69},
    {0.2904, 0.9540, 0.0203, 104.41}, {0.4334, 0.9950, 0.0087, 104.05},
    {0.5945, 0.9950, 0.0039, 100.00}, {0.7621, 0.9520, 0.0021, 96.33},
    {0.9163, 0.8700, 0.0017, 95.79},  {1.0263, 0.7570, 0.0011, 88.69},
    {1.0622, 0.6310, 0.0008, 90.01},  {1.0026, 0.5030, 0.0003, 89.60},
    {0.8544, 0.3810, 0.0002, 87.70},  {0.6424, 0.2650, 0.0000, 83.29},
    {0.4479, 0.1750, 0.0000, 83.70},  {0.2835, 0.1070, 0.0000, 80.03},
    {0.1649, 0.0610, 0.0000, 80.21},  {0.0874, 0.0320, 0.0000, 82.28},
    {0.0468, 0.0170, 0.0000, 78.28},  {0.0227, 0.0082, 0.0000, 69.72},
    {0.0114, 0.0041, 0.0000, 71.61},  {0.0058, 0.0021, 0.0000, 74.35},
    {0.0029, 0.0010, 0.0000, 61.60},  {0.0014, 0.0005, 0.0000, 69.89},
    {0.0007, 0.0002, 0.0000, 75.09},  {0.0003, 0.0001, 0.0000, 63.59},
    {0.0002, 0.0001, 0.0000, 46.42},  {0.0001, 0.0000, 0.0000, 66.81},
    {0.0000, 0.0000, 0.0000, 63.38},
}};

// Samples a step apart would miss narrow lines: every nanometre, between the rows linearly.
constexpr int samples_a_step = 10;

struct Integral {
  Vec3d xyz{0.0};
  double d65_y = 0;  // of the illuminant alone
};

Integral integrate(const SpectrumFunction& spectrum, bool is_lit_by_d65) {
  Integral sum;
  const int count = static_cast<int>(rows.size() - 1) * samples_a_step;
  for (int i = 0; i <= count; ++i) {
    const double at = static_cast<double>(i) / samples_a_step;
    const auto row = std::min(static_cast<std::size_t>(at), rows.size() - 2);
    const double f = at - static_cast<double>(row);
    const auto mixed = [&](double Row::*column) {
      return rows[row].*column * (1 - f) + rows[row + 1].*column * f;
    };
    const double light = is_lit_by_d65 ? mixed(&Row::d65) : 1.0;
    const double value = spectrum(first_wavelength + step * at) * light;
    sum.xyz += Vec3d(mixed(&Row::x), mixed(&Row::y), mixed(&Row::z)) * value;
    sum.d65_y += mixed(&Row::y) * light;
  }
  return sum;
}

Vec3d clamped(const Vec3d& colour) {
  return glm::max(colour, Vec3d(0.0));
}

Vec3d of_luminance_one(const Vec3d& xyz) {
  const Vec3d colour = clamped(xyz_to_rgb(xyz / xyz.y));
  return colour / luminance(colour);
}

}  // namespace

double SampledSpectrum::operator()(double wavelength) const {
  if (wavelengths.empty() || wavelength < wavelengths.front() || wavelength > wavelengths.back())
    return 0;
  const auto above = std::upper_bound(wavelengths.begin(), wavelengths.end(), wavelength);
  if (above == wavelengths.end()) return values.back();
  const auto i = static_cast<std::size_t>(above - wavelengths.begin());
  const double f = (wavelength - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1]);
  return values[i - 1] + (values[i] - values[i - 1]) * f;
}

// [Planck01]; c2 = hc / k in nanometre kelvins.
double black_body(double wavelength, double kelvin) {
  constexpr double c2 = 1.438776877e7;
  // Relative to 560 nm, so that no temperature overflows.
  const auto exponent = [&](double nanometres) { return c2 / (nanometres * kelvin); };
  const double ratio = std::pow(560 / wavelength, 5);
  if (exponent(560) > 30)  // Wien's law, where exp would overflow
    return ratio * std::exp(std::min(exponent(560) - exponent(wavelength), 700.0));
  return ratio * std::expm1(exponent(560)) / std::expm1(exponent(wavelength));
}

// Rec.709's primaries and D65 [Rec709].
Vec3d xyz_to_rgb(const Vec3d& c) {
  return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z,
          -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
          0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

Vec3d xyz_of_light(const SpectrumFunction& spectrum) {
  return integrate(spectrum, false).xyz;
}

Vec3d colour_of_light(const SpectrumFunction& spectrum) {
  const Vec3d xyz = xyz_of_light(spectrum);
  return xyz.y > 0 ? of_luminance_one(xyz) : Vec3d(0.0);
}

Vec3d colour_of_chromaticity(double x, double y) {
  return of_luminance_one({x, y, 1 - x - y});
}

Vec3d colour_of_factor(const SpectrumFunction& spectrum) {
  const Vec3d white = xyz_to_rgb(integrate([](double) { return 1.0; }, true).xyz);
  return clamped(xyz_to_rgb(integrate(spectrum, true).xyz) / white);
}

double luminous_mean(const SpectrumFunction& spectrum) {
  const Integral sum = integrate(spectrum, false);
  return sum.xyz.y / sum.d65_y;
}

}  // namespace candela
