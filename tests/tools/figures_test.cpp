// tools/figures: the page is whole, and what it says is what this run rendered.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <regex>

#include "renderer/image/image_io.h"
#include "tests/tools/run_program.h"

namespace candela::cli_test {
namespace {

using Json = nlohmann::json;

constexpr const char* python = "/usr/bin/python3";  // Debian's, as in tools/figures

bool has_matplotlib() {
  return std::filesystem::exists(python) &&
         Program({python, "-c", "import matplotlib, numpy"}, ErrorStream::File)
                 .finish()
                 .exit_code == 0;
}

// `scenes`: the folder that holds lab3/.
ProgramResult run_figures(const std::string& scenes, const std::string& out,
                          const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"/usr/bin/env",
                                 "CANDELA_SCENES=" + scenes,
                                 python,
                                 "-B",
                                 CANDELA_SOURCE_DIR "/tools/dev/figures/main.py",
                                 "--tiny",
                                 "--program",
                                 CANDELA_PROGRAM,
                                 "--out",
                                 out};
  words.insert(words.end(), more.begin(), more.end());
  return Program(words, ErrorStream::File).finish();
}

struct FiguresRun {
  std::string folder;
  std::string page;
  Json record;  // figures.json

  const Json& figure(const std::string& name) const {
    for (const Json& figure : record.at("figures"))
      if (figure.at("name") == name) return figure;
    throw std::out_of_range("no figure " + name);
  }
};

std::optional<FiguresRun> run_of(const std::string& folder, const ProgramResult& result) {
  EXPECT_EQ(result.exit_code, 0) << result.error;
  if (result.exit_code != 0) return std::nullopt;
  return FiguresRun{folder, file_text(folder + "/index.html"),
                    Json::parse(file_text(folder + "/figures.json"))};
}

std::string from_base64(std::string_view text) {
  static constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned held = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) break;  // '=': the end
    held = (held << 6 | static_cast<unsigned>(digit)) & 0xffff;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<char>(held >> bits & 0xff));
  }
  return bytes;
}

// The sources of the page's pictures. (Regular expressions recurse too deeply on texts so long.)
std::vector<std::string_view> picture_sources(std::string_view page) {
  std::vector<std::string_view> sources;
  constexpr std::string_view key = "src=\"";
  for (std::size_t at = 0; (at = page.find(key, at)) != std::string_view::npos;) {
    at += key.size();
    sources.push_back(page.substr(at, page.find('"', at) - at));
  }
  return sources;
}

// Each picture is in the page itself, decodes, and is neither black nor of one colour.
void expect_whole_pictures(const FiguresRun& run) {
  std::size_t expected = 0;
  for (const Json& figure : run.record["figures"]) {
    expected += figure["plots"].size();
    for (const Json& row : figure["rows"]) expected += row.count("picture");
  }
  const std::vector<std::string_view> sources = picture_sources(run.page);
  EXPECT_EQ(sources.size(), expected);
  constexpr std::string_view start = "data:image/png;base64,";
  const std::string file = run.folder + "/embedded.png";
  for (const std::string_view source : sources) {
    ASSERT_TRUE(source.starts_with(start)) << source.substr(0, 80);
    write_text(file, from_base64(source.substr(start.size())));
    const Result<Image> image = read_image(file);
    ASSERT_TRUE(image);
    const std::vector<float>& values = image->values;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    EXPECT_GT(std::accumulate(values.begin(), values.end(), 0.0),
              0.005 * static_cast<double>(values.size()));
    EXPECT_GT(*high - *low, 0.02f);
  }
}

// Each number that a table shows is that of figures.json, and none of the latter is left out.
void expect_numbers_of_the_record(const FiguresRun& run) {
  std::size_t expected = 0;
  for (const Json& figure : run.record["figures"])
    expected += figure["columns"].size() * figure["rows"].size();
  static const std::regex cell("^<td data-of=\"([a-z_0-9]+)/([^\"]+)\">([^<]+)</td>");
  std::size_t found = 0;
  for (std::size_t at = 0; (at = run.page.find("<td data-of", at)) != std::string::npos; ++at) {
    const std::string text = run.page.substr(at, 200);
    std::smatch match;
    ASSERT_TRUE(std::regex_search(text, match, cell)) << text;
    const double recorded = run.figure(match[1]).at(Json::json_pointer("/" + match[2].str()));
    EXPECT_NEAR(std::stod(match[3]), recorded, 5.1e-4 * std::abs(recorded)) << text;
    ++found;
  }
  EXPECT_EQ(found, expected);
}

// Samples and seconds are those that candela wrote beside the picture.
void expect_times_of_this_run(const FiguresRun& run) {
  int rows = 0;
  for (const Json& figure : run.record["figures"]) {
    for (const Json& row : figure["rows"]) {
      if (!row.contains("stats")) continue;
      const Json stats = Json::parse(file_text(run.folder + "/" + row["stats"].get<std::string>()));
      EXPECT_GT(row["seconds"], 0);
      EXPECT_EQ(row["seconds"], stats["seconds"]["render"]);
      EXPECT_EQ(row["spp"], stats["spp"]);
      ++rows;
    }
  }
  EXPECT_GE(rows, 21);
}

// relMSE, once more from the pictures that are there.
void expect_errors_of_the_pictures(const FiguresRun& run) {
  for (const std::string name : {"figure_1", "figure_5"}) {
    const Json& row = run.figure(name)["rows"][0];
    const std::filesystem::path picture = run.folder + "/" + row["picture"].get<std::string>();
    const std::string image = std::filesystem::path(picture).replace_extension("exr").string();
    const ProgramResult result = run_candela(
        {"compare", image, run.folder + "/renders/reference_cornell_box.exr", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.error;
    EXPECT_EQ(Json::parse(result.output)["relmse"], row["relmse"]) << name;
  }
}

// The numbers tell what the page's sentences say.
void expect_what_the_sentences_say(const FiguresRun& run) {
  const Json& convergence = run.figure("figure_1")["rows"];
  EXPECT_GT(convergence.front()["relmse"], convergence.back()["relmse"]);
  const Json& bleeding = run.figure("figure_3")["rows"];
  EXPECT_NEAR(bleeding[0]["redness"], 1, 0.01);
  EXPECT_GT(bleeding[1]["redness"], 3);
  int encoded = 0;
  for (const Json& row : run.figure("encoded_average")["rows"]) {
    // Of so few samples of so small a picture none may have met the lamp.
    if (row["spp"] != 4 || row["linear"] == 0) continue;
    EXPECT_LT(row["encoded_each"], row["encoded_once"]) << row;
    ++encoded;
  }
  EXPECT_GT(encoded, 0);
  const Json& strategies = run.figure("figure_5")["rows"];
  ASSERT_EQ(strategies[5]["caption"], "all diffuse, uniform");
  EXPECT_GT(strategies[5]["relmse"], strategies[6]["relmse"]) << strategies[6]["caption"];
  const Json& furnace = run.figure("furnace")["rows"];
  for (const Json& row : furnace) EXPECT_NEAR(row["compensated"], 1, 0.02) << row;
  // Mean albedo of roughness .2 and 1, by a Monte Carlo integral of its own.
  EXPECT_NEAR(furnace[0]["single"], 0.916, 0.01);
  EXPECT_NEAR(furnace[1]["single"], 0.408, 0.01);
}

TEST(Unit_Figures, ThePageIsWholeAndItsNumbersAreOfThisRun) {
  if (!has_matplotlib()) GTEST_SKIP() << "Debian's python3-matplotlib is not installed";
  const std::string scenes = fresh_folder("scenes"), out = fresh_folder("page");
  std::filesystem::create_directories(scenes + "/lab3");
  std::filesystem::copy(CANDELA_SOURCE_DIR "/assets/cutouts", scenes + "/lab3/cutouts");
  const std::optional<FiguresRun> run = run_of(out, run_figures(scenes, out));
  ASSERT_TRUE(run);
  EXPECT_EQ(run->figure("course_scenes")["rows"].size(), 2u);
  expect_whole_pictures(*run);
  expect_numbers_of_the_record(*run);
  expect_times_of_this_run(*run);
  expect_errors_of_the_pictures(*run);
  expect_what_the_sentences_say(*run);
}

TEST(Unit_Figures, AbsentScenesAreSaid) {
  if (!has_matplotlib()) GTEST_SKIP() << "Debian's python3-matplotlib is not installed";
  const std::string scenes = fresh_folder("scenes"), out = fresh_folder("page");
  const std::optional<FiguresRun> run =
      run_of(out, run_figures(scenes, out, {"--only", "course_scenes"}));
  ASSERT_TRUE(run);
  EXPECT_EQ(run->figure("course_scenes")["rows"].size(), 0u);
  EXPECT_NE(run->page.find("No such scene is here"), std::string::npos);
}

TEST(Unit_Figures, WhatCandelaRefusesIsSaidInItsWords) {
  if (!has_matplotlib()) GTEST_SKIP() << "Debian's python3-matplotlib is not installed";
  const std::string scenes = fresh_folder("scenes"), out = fresh_folder("page");
  std::filesystem::create_directories(scenes + "/lab3/broken");
  write_text(scenes + "/lab3/broken/broken.yaml", "Models:\n  - Mesh: absent.obj\n");
  const ProgramResult result = run_figures(scenes, out, {"--only", "course_scenes"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.error.find("broken.yaml:2"), std::string::npos) << result.error;
  EXPECT_FALSE(std::filesystem::exists(out + "/index.html"));
}

// Two of our scenes and one with a reference: each has its line, its numbers and its pictures.
TEST(Unit_Gallery, ShowsEachSceneWithItsNumbers) {
  if (!has_matplotlib()) GTEST_SKIP() << "Debian's python3-matplotlib is not installed";
  const std::string scenes = fresh_folder("scenes"), out = fresh_folder("page");
  std::filesystem::create_directories(scenes + "/lab3");
  std::filesystem::create_directories(scenes + "/lab3-pictures");
  std::filesystem::copy(CANDELA_SOURCE_DIR "/assets/cutouts", scenes + "/lab3/cutouts");
  std::filesystem::copy(CANDELA_SOURCE_DIR "/assets/cutouts/tiles.png",
                        scenes + "/lab3-pictures/cutouts-depth5.png");
  const ProgramResult result =
      run_figures(scenes, out,
                  {"--gallery", "--spp", "4", "--size", "24", "--scene", "cornell_box", "--scene",
                   "pbrt_lights", "--scene", "lab3/cutouts"});
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const std::string page = file_text(out + "/index.html");
  const Json record = Json::parse(file_text(out + "/gallery.json"));
  ASSERT_EQ(record["rows"].size(), 3u);
  EXPECT_EQ(picture_sources(page).size(), 4u);
  for (const std::string_view source : picture_sources(page))
    EXPECT_TRUE(source.starts_with("data:image/png;base64,"));
  for (const Json& row : record["rows"]) {
    const Json stats = Json::parse(file_text(out + "/" + row["stats"].get<std::string>()));
    EXPECT_EQ(std::max(row["width"].get<int>(), row["height"].get<int>()), 24) << row["caption"];
    EXPECT_EQ(row["spp"], 4);
    EXPECT_EQ(row["seconds"], stats["seconds"]["render"]);
    EXPECT_EQ(row["stated_rmse"], stats["error"]["rmse"]);
    EXPECT_NE(page.find("<h2>" + row["caption"].get<std::string>() + "</h2>"), std::string::npos);
  }
  EXPECT_EQ(record["rows"][2]["reference_by"], "the course's ray tracer");
  EXPECT_FALSE(record["rows"][0].contains("reference"));
}

// A picture held against itself: no difference; one that is a tenth darker: as much everywhere.
TEST(Unit_Gallery, DifferencesToPbrtsPicturesAreThoseOfTheLuminance) {
  if (!has_matplotlib()) GTEST_SKIP() << "Debian's python3-matplotlib is not installed";
  const ProgramResult result =
      Program(
          {python, "-B", "-c",
           "import sys, numpy\n"
           "sys.path += ['" CANDELA_SOURCE_DIR "/tools/dev/figures',\n"
           "             '" CANDELA_SOURCE_DIR "/tools/dev/shared']\n"
           "from pbrt_differences import difference, sheet\n"
           "a = numpy.random.RandomState(1).rand(17, 25, 3)\n"
           "d = difference(a, a)\n"
           "print(d.shape, abs(d).max())\n"
           "print(round(difference(.9 * a, a).min(), 6), round(difference(.9 * a, a).max(), 6))\n"
           "b = a.copy(); b[8:16, 0:8] = 0\n"
           "print(round(difference(b, a)[1, 0], 6), abs(difference(b, a)[0]).max())\n"
           "print(difference(0 * a, 0 * a).max(), sheet([('x', a, b)]).size)\n"},
          ErrorStream::File)
          .finish();
  EXPECT_EQ(result.output, "(2, 3) 0.0\n-0.105263 -0.105263\n-2.0 0.0\n0.0 (1056, 143)\n")
      << result.error;
}

}  // namespace
}  // namespace candela::cli_test
