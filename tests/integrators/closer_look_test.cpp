// Looking closer at pixels with rare light: the stated error is right, the picture is as without.
#include "integrators/closer_look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>

#include "integrators/render_rounds.h"
#include "integrators/seed_stream.h"
#include "renderer/base/parallel.h"
#include "tests/film/synthetic_film.h"
#include "tests/integrators/synthetic_tile.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

constexpr int size = 24;
constexpr double dark = 0.02;
constexpr double flash = 120;
constexpr double probability = 1e-3;

// A dark picture beside a bright half; in one of its rows a sample in a thousand meets a lamp.
double steady(int x) {
  return x < size / 2 ? dark : 1;
}
bool may_flash(int x, int y) {
  return y == 11 && x < size / 2;
}
double truth(int x, int y) {
  return steady(x) + (may_flash(x, y) ? flash * probability : 0);
}

TileCounts flashing_tile(const TilePass& pass, Film& film) {
  return synthetic_tile(pass, film, [](std::uint64_t bits, int x, int y) {
    const double light = steady(x) * (0.5 + unit_double(mix_bits(bits + 1)));
    const bool flashes = may_flash(x, y) && unit_double(mix_bits(bits + 2)) < probability;
    return light + (flashes ? flash : 0);
  });
}

struct Result {
  Film film{size, size, {0, 0, size, size}, 0, 4};
  RoundsDone done;
};

Result render(const RenderSettings& settings) {
  Result result;
  result.done = render_rounds(settings.options, flashing_tile, result.film, nullptr, nullptr);
  return result;
}

// Of the picture alone, the error of this one is stated six times too high: the neighbours of
// pixels that met the lamp are dark, and nothing tells how bright those are in the mean.
TEST(Statistical_CloserLook, StatesTheTrueErrorOfRareLight) {
  constexpr int seeds = 1000;
  double error = 0;
  double by_picture_alone = 0;
  double difference = 0;
  double squared_difference = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Result result = render(settings_of(size, 32, seed));
    const double truth_of_it = relmse_to(truth, result.film);
    const double off = result.done.error->relmse - truth_of_it;
    error += truth_of_it;
    by_picture_alone += estimate_error(result.film)->relmse;
    difference += off;
    squared_difference += off * off;
  }
  const double deviation = std::sqrt(squared_difference);  // of the sum
  EXPECT_LT(deviation, 0.05 * error) << "too few pictures to tell";
  EXPECT_LT(std::abs(difference), 3 * deviation);
  EXPECT_GT(by_picture_alone, 3 * error);
}

bool never() {
  return false;
}

// What all looks of a round render into would take more memory than the picture.
TEST(Unit_CloserLook, HoldsOneFilmAThread) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "what is freed keeps its address: films' tell nothing";
#endif
  const RenderSettings settings = settings_of(size, 256, 5);
  Film film(size, size, {0, 0, size, size}, 0, 4);
  flashing_tile({film.crop(), {0, 256}, nullptr, 5}, film);
  PixelErrors errors = *estimate_pixel_errors(film);
  std::set<const Film*> films;
  std::size_t looks = 0;
  const TileFunction remember = [&](const TilePass& pass, Film& of) {
    films.insert(&of);
    ++looks;
    return flashing_tile(pass, of);
  };
  with_threads(1, [&] {
    CloserLook look(settings.options, remember, never);
    look.correct(film, {}, errors);
  });
  EXPECT_GT(looks, 16u);
  EXPECT_LE(films.size(), 4u);
}

constexpr std::uint32_t many = 256;  // samples a pixel that are sure to meet the lamp in some

TEST(Unit_CloserLook, LeavesThePictureAsItIs) {
  const RenderSettings settings = settings_of(size, many, 5);
  const Result result = render(settings);
  ASSERT_GT(result.done.error->looked_at, 0u);
  EXPECT_GT(result.done.error->look_samples, 0u);
  Film alone(size, size, {0, 0, size, size}, 0, 4);
  flashing_tile({{0, 0, size, size}, {0, many}, nullptr, 5}, alone);
  for (std::size_t i = 0; i < alone.pixel_count(); ++i)
    for (std::uint32_t r = 0; r < 4; ++r)
      EXPECT_EQ(alone.replicate_sum(i, r), result.film.replicate_sum(i, r));
}

// Of which those that choose the roulette are counters of a seed, too.
TEST(Unit_CloserLook, HasRandomNumbersOfItsOwn) {
  std::vector<std::uint64_t> taken;
  for (const SeedStream stream : {SeedStream::LampPixels, SeedStream::GuideTraining,
                                  SeedStream::GuideTrial, SeedStream::Roulette, SeedStream::Reuse})
    for (std::uint64_t n = 0; n < 1024; ++n) taken.push_back(hash_counter(seed_of(stream, 5), n));
  std::mutex mutex;
  std::vector<std::uint64_t> looks;
  Film film(size, size, {0, 0, size, size}, 0, 4);
  const RoundsDone done = render_rounds(
      settings_of(size, many, 5).options,
      [&](const TilePass& pass, Film& target) {
        const std::lock_guard lock(mutex);
        if (pass.seed != 5) looks.push_back(pass.seed);
        return flashing_tile(pass, target);
      },
      film, nullptr, nullptr);
  ASSERT_GT(done.error->looked_at, 0u);
  for (const std::uint64_t seed : looks) EXPECT_EQ(std::count(taken.begin(), taken.end(), seed), 0);
}

// A pixel of a crop is looked at where it stands in the whole picture.
TEST(Unit_CloserLook, LooksAtThePixelsOfACrop) {
  const RenderSettings settings = settings_of(size, many, 5);
  const PixelRect crop{2, 9, 12, 20};
  Film film(size, size, crop, 0, 4);
  std::mutex mutex;
  std::vector<PixelRect> seen;
  const TileFunction remember = [&](const TilePass& pass, Film& of) {
    const std::lock_guard lock(mutex);
    seen.push_back(pass.tile);
    return flashing_tile(pass, of);
  };
  flashing_tile({crop, {0, many}, nullptr, 5}, film);
  PixelErrors errors = *estimate_pixel_errors(film);
  CloserLook look(settings.options, remember, never);
  look.correct(film, {}, errors);
  ASSERT_FALSE(seen.empty());
  for (const PixelRect& pixel : seen) {
    EXPECT_EQ(pixel.width() * pixel.height(), 1);
    EXPECT_TRUE(may_flash(pixel.x0, pixel.y0));
  }
}

// Which of a look's samples are invalid tells nothing of the picture's.
TEST(Unit_CloserLook, CountsInvalidSamplesAndLocatesNone) {
  const RenderSettings settings = settings_of(size, many, 5);
  Film film(size, size, {0, 0, size, size}, 0, 4);
  flashing_tile({film.crop(), {0, many}, nullptr, 5}, film);
  PixelErrors errors = *estimate_pixel_errors(film);
  const TileFunction flawed = [](const TilePass& pass, Film& of) {
    TileCounts counts = flashing_tile(pass, of);
    counts.invalid_samples = 1;
    counts.add_invalid({pass.tile.x0, pass.tile.y0, 7});
    return counts;
  };
  CloserLook look(settings.options, flawed, never);
  EXPECT_GT(look.correct(film, {}, errors), 0u);
}

Film film_of(std::uint32_t samples, std::uint64_t seed) {
  Film film(size, size, {0, 0, size, size}, 0, 4);
  flashing_tile({film.crop(), {0, samples}, nullptr, seed}, film);
  return film;
}

// What has been seen of an early picture counts for a later one, which wants more of other pixels.
TEST(Unit_CloserLook, GoesOnWhereItEnded) {
  const RenderSettings settings = settings_of(size, many, 5);
  const Film early = film_of(many, 5);
  const Film late = film_of(2 * many, 5);
  PixelErrors of_early = *estimate_pixel_errors(early);
  CloserLook look(settings.options, flashing_tile, never);
  look.correct(early, {}, of_early);
  const std::uint64_t samples = look.samples();
  ASSERT_GT(samples, 0u);
  PixelErrors again = *estimate_pixel_errors(early);
  look.correct(early, {}, again);
  EXPECT_EQ(look.samples(), samples);
  EXPECT_EQ(again.errors, of_early.errors);

  PixelErrors of_late = *estimate_pixel_errors(late);
  look.correct(late, {}, of_late);
  EXPECT_GT(look.samples(), samples);
  CloserLook fresh(settings.options, flashing_tile, never);
  PixelErrors at_once = *estimate_pixel_errors(late);
  fresh.correct(late, {}, at_once);
  EXPECT_LE(fresh.samples(), look.samples());
  EXPECT_LE(look.samples(), std::uint64_t{1} << 17);
}

TEST(Unit_CloserLook, LeavesErrorsAloneWhereThereIsNoTime) {
  const RenderSettings settings = settings_of(size, many, 5);
  const Film film = film_of(many, 5);
  const PixelErrors before = *estimate_pixel_errors(film);
  PixelErrors errors = before;
  CloserLook late(settings.options, flashing_tile, [] { return true; });
  late.correct(film, {}, errors);
  EXPECT_EQ(errors.errors, before.errors);
  EXPECT_EQ(late.pixels(), 0u);
}

// Two pixels of one row, each of which wants more than there is: the worse one gets it.
TEST(Unit_CloserLook, SpendsItsBudgetOnTheWorst) {
  Film tiny(4, 1, {0, 0, 4, 1}, 0, 4);
  for (int i = 0; i < 64; ++i)
    for (int x = 0; x < 4; ++x) {
      FilmSample sample;
      sample.radiance = Rgb(1 + 0.01f * static_cast<float>(i % 7));
      if (i == 0 && x < 2) sample.radiance = Rgb(x == 0 ? 1e6f : 3e6f);
      tiny.add(x, 0, sample);
    }
  const PixelErrors before = *estimate_pixel_errors(tiny);
  ASSERT_EQ(doubtful_pixels(tiny, before).size(), 2u);
  PixelErrors errors = before;
  const RenderSettings settings = settings_of(4, 64, 5);
  CloserLook look(settings.options, flashing_tile, never);
  look.correct(tiny, {}, errors);
  EXPECT_EQ(look.samples(), 4u * 4 * 64);  // four times those of the picture
  EXPECT_EQ(errors.errors[0], before.errors[0]);
  EXPECT_NE(errors.errors[1], before.errors[1]);
}

}  // namespace
}  // namespace candela
