// --without on the command line.
#include "tools/candela/savings.h"

#include <nlohmann/json.hpp>

#include "renderer/image/image_io.h"
#include "tests/scenes/render_scene.h"
#include "tests/tools/refusals.h"
#include "tools/candela/option_values.h"

namespace candela::cli {
namespace {

using namespace cli_test;

TEST(Unit_Savings, AreReadAndToldInOneOrder) {
  const Result<SavingSet> set = parse_savings("convoys,packets,convoys");
  ASSERT_TRUE(set);
  EXPECT_EQ(*set, saving_bit(Saving::Packets) | saving_bit(Saving::Convoys));
  EXPECT_EQ(savings_text(*set), "packets,convoys");
  EXPECT_EQ(savings_text(0), "");
  EXPECT_EQ(saving_of_path(*set), "packets");
  EXPECT_EQ(saving_of_embree(*set), "packets");
  const SavingSet of_all = saving_bit(Saving::FlushedDenormals) | saving_bit(Saving::LargePages);
  EXPECT_EQ(saving_of_path(of_all), "");
  EXPECT_EQ(saving_of_embree(of_all), "");
}

TEST(Unit_Savings, AreWhatTheRoomsAreTold) {
  const EmbreeOptions slow =
      embree_options_without(*parse_savings("packets,high-quality"), {.robust = false});
  EXPECT_FALSE(slow.packets || slow.high_quality || slow.robust);
  const EmbreeOptions usual = embree_options_without(0, {});
  EXPECT_TRUE(usual.packets && usual.high_quality && usual.robust);
  const PathSavings none =
      path_savings_without(*parse_savings("shared-blocks,convoys,background,opacity-grids"));
  EXPECT_FALSE(none.shares_blocks || none.has_convoys || none.skips_background ||
               none.opacity_grids);
  const PathSavings all = path_savings_without(0);
  EXPECT_TRUE(all.shares_blocks && all.has_convoys && all.skips_background && all.opacity_grids);
}

TEST(Errors_Savings, AreRefusedInSentences) {
  expect_refused({cornell_box, "--without", "pakets"}, 2,
                 "unknown saving 'pakets', did you mean 'packets'?");
  expect_refused({cornell_box, "--without", ""}, 2, "unknown saving ''");
  expect_refused({cornell_box, "--integrator", "whitted", "--without", "flushing,convoys"}, 2,
                 "--without convoys is for path, this is whitted");
  expect_refused({cornell_box, "--accel", "bvh", "--without", "high-quality"}, 2,
                 "--without high-quality is for Embree, this is --accel bvh");
  expect_refused({cornell_box, "--robust", "off", "--accel", "bvh"}, 2,
                 "--robust off is for Embree, this is --accel bvh");
}

// The list of faces asks no packets in so small a scene, so that all is as before.
TEST(Unit_Savings, APictureWithoutThemTellsSo) {
  const std::string folder = fresh_folder("savings");
  const auto image = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> words{"render",  cornell_box,
                                   "--size",  "16x16",
                                   "--spp",   "5",
                                   "-o",      folder + "/" + name + ".exr",
                                   "--stats", folder + "/" + name + ".json"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_candela(words).exit_code, 0);
    return nlohmann::json::parse(file_text(folder + "/" + name + ".json"))["without"]
        .get<std::string>();
  };
  EXPECT_EQ(image("with", {}), "");
  const std::string all =
      "packets,high-quality,flushing,large-pages,shared-blocks,convoys,background,opacity-grids";
  EXPECT_EQ(image("without", {"--without", all}), all);
  const ProgramResult compared =
      run_candela({"compare", folder + "/without.exr", folder + "/with.exr", "--max-relmse", "0"});
  EXPECT_EQ(compared.exit_code, 0) << compared.output;
}

// A sky so dim that its radiance is a denormal number.
TEST(Unit_Savings, WithoutFlushingDenormalsStay) {
  const std::string folder = fresh_folder("denormals");
  write_text(folder + "/triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto mean_of_sky = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"render",    folder + "/triangle.obj",
                                   "--ambient", "1e-40,1e-40,1e-40",
                                   "--size",    "4x4",
                                   "--spp",     "1",
                                   "-o",        folder + "/a.exr"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_candela(words).exit_code, 0);
    return test::mean_of(*read_image(folder + "/a.exr"));
  };
  EXPECT_EQ(mean_of_sky({}), 0);
  EXPECT_GT(mean_of_sky({"--without", "flushing"}), 0);
}

}  // namespace
}  // namespace candela::cli
