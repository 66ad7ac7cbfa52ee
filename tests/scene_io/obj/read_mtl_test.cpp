#include "scene_io/obj/read_mtl.h"

#include <gtest/gtest.h>

namespace candela::obj {
namespace {

using namespace description;

MtlLibrary parse(std::string_view text, MtlUse use) {
  Diagnostics diagnostics;
  MtlLibrary library = parse_mtl("folder/a.mtl", text, use, diagnostics);
  for (const Diagnostic& d : diagnostics.list()) ADD_FAILURE() << to_string(d);
  return library;
}

Material only(std::string_view statements, MtlUse use) {
  MtlLibrary library = parse("newmtl m\n" + std::string(statements), use);
  return library.materials.at(0);
}
LabMaterial lab(std::string_view statements, MtlUse use = MtlUse::Lab) {
  return std::get<LabMaterial>(only(statements, use).model);
}

TEST(Unit_Mtl, LabDefaultsAreTheLoaders) {
  const LabMaterial m = lab("");
  EXPECT_EQ(m.diffuse.factor, Vec3d(0.0));
  EXPECT_EQ(m.specular.factor, Vec3d(0.0));
  EXPECT_EQ(m.shininess, 1.0);
  EXPECT_EQ(m.alpha, 1.0);
  EXPECT_FALSE(m.diffuse.map);
}

TEST(Unit_Mtl, LabFactorsAreClampedAndNotRounded) {
  const LabMaterial m = lab("Kd 0.123456 2 -1\nKs .1 .2 .3\nNs 1000\nd 0.3\n");
  EXPECT_EQ(m.diffuse.factor, Vec3d(0.123456, 1, 0));
  EXPECT_EQ(m.specular.factor, Vec3d(0.1, 0.2, 0.3));
  EXPECT_EQ(m.shininess, 256.0);
  EXPECT_EQ(m.alpha, 0.3);
}

TEST(Unit_Mtl, LabReadsOneNumberAsGrey) {
  EXPECT_EQ(lab("Kd .25\n").diffuse.factor, Vec3d(0.25));
}

TEST(Unit_Mtl, DissolveWinsOverTransparencyInEitherOrder) {
  EXPECT_EQ(lab("Tr .25\n").alpha, 0.75);
  EXPECT_EQ(lab("Tr .25\nd .5\n").alpha, 0.5);
  EXPECT_EQ(lab("d .5\nTr .25\n").alpha, 0.5);
}

TEST(Unit_Mtl, LabMapsReplaceFactorsAndAlpha) {
  const MtlLibrary library = parse(
      "newmtl m\nKd 0 0 0\nd .2\nmap_Kd -s 2 2 2 -clamp on a b.png\nmap_Ks tex\\s.png\n"
      "map_bump -bm 5 h1.png\nbump h2.png\nmap_d ignored.png\nnorm ignored.png\n",
      MtlUse::Lab);
  const Material& m = library.materials.at(0);
  const auto& model = std::get<LabMaterial>(m.model);
  ASSERT_EQ(library.images.size(), 3u);
  const Image& diffuse = library.images[model.diffuse.map.index];
  EXPECT_EQ(diffuse.path, "folder/a b.png");
  EXPECT_EQ(diffuse.encoding, Encoding::LabGamma);
  EXPECT_EQ(diffuse.wrap, Wrap::Repeat);
  EXPECT_EQ(diffuse.span.line, 4u);
  EXPECT_EQ(model.alpha, 1.0);
  const Image& specular = library.images[model.specular.map.index];
  EXPECT_EQ(specular.path, "folder/tex/s.png");
  EXPECT_EQ(specular.encoding, Encoding::Linear);
  EXPECT_EQ(library.images[m.height.index].path, "folder/h2.png");
  EXPECT_EQ(m.height_scale, bump_height);
  EXPECT_FALSE(m.normal_map);
  EXPECT_FALSE(m.opacity.map);
}

TEST(Unit_Mtl, LabIgnoresWhatTheCourseIgnores) {
  const Material m =
      only("Ke 5 5 5\nNi 1.5\nTf 0 0 0\nillum 7\nPr .5\nPm 1\nmap_Ke x.png\nNi malformed\n",
           MtlUse::Lab);
  EXPECT_TRUE(std::holds_alternative<LabMaterial>(m.model));
  EXPECT_EQ(m.emission, Vec3d(0.0));
  EXPECT_EQ(m.opacity.factor, 1.0);
}

TEST(Unit_Mtl, KeywordsMayBeOfAnyLetterCase) {
  EXPECT_EQ(lab("kd .5 .5 .5\nKS .1 .1 .1\nns 3\n").diffuse.factor, Vec3d(0.5));
}

TEST(Unit_Mtl, NamesMayHoldColonsAndSpaces) {
  const MtlLibrary library =
      parse("newmtl  breakfast:room  tiles #2 \r\nKd 1 1 1\r\n", MtlUse::Lab);
  EXPECT_EQ(library.materials.at(0).name, "breakfast:room  tiles #2");
}

TEST(Unit_Mtl, FullEmissionOpacityBumpAndNormalMap) {
  const MtlLibrary library = parse(
      "newmtl m\nKd .5 .5 .5\nKe 17 12 4\nmap_d -imfchan g mask.png\nmap_Bump -bm 3 h.png\n"
      "norm n.png\nNs 900\n",
      MtlUse::Full);
  const Material& m = library.materials.at(0);
  EXPECT_EQ(m.emission, Vec3d(17, 12, 4));
  EXPECT_TRUE(m.emits_both_sides);
  EXPECT_EQ(library.images.at(m.opacity.map.index).path, "folder/mask.png");
  EXPECT_EQ(m.opacity.channel, 1);
  EXPECT_DOUBLE_EQ(m.height_scale, 3 * bump_height);
  EXPECT_EQ(library.images.at(m.normal_map.index).path, "folder/n.png");
  EXPECT_EQ(std::get<LabMaterial>(m.model).shininess, 900.0);
}

// A factor of Ke, which is 1 where only the map is there.
TEST(Unit_Mtl, FullEmissionByAMap) {
  const MtlLibrary library = parse(
      "newmtl a\nKe 2 3 4\nmap_Ke a.png\nnewmtl b\nmap_Ke a.png\nnewmtl c\nKe 0 0 0\n"
      "map_Ke a.png\n",
      MtlUse::Full);
  EXPECT_EQ(library.materials.at(0).emission, Vec3d(2, 3, 4));
  EXPECT_EQ(library.materials.at(1).emission, Vec3d(1.0));
  EXPECT_EQ(library.images.at(library.materials.at(1).emission_map.index).path, "folder/a.png");
  EXPECT_EQ(library.images.at(0).encoding, Encoding::Srgb);
  EXPECT_EQ(library.materials.at(2).emission, Vec3d(0.0));
  EXPECT_FALSE(library.materials.at(2).emission_map);
}

TEST(Unit_Mtl, FullOpacityIsSaidOnce) {
  EXPECT_EQ(lab("Kd 1 1 1\nd .5\n", MtlUse::Full).alpha, 0.5);
  EXPECT_EQ(only("Kd 1 1 1\nd .5\n", MtlUse::Full).opacity.factor, 1.0);
  // With a map the model's alpha is the map's, so d is the surface's.
  EXPECT_EQ(only("map_Kd a.png\nd .5\n", MtlUse::Full).opacity.factor, 0.5);
  EXPECT_FALSE(only("map_Kd a.png\nmap_d a.png\n", MtlUse::Full).opacity.map);
  EXPECT_TRUE(only("map_Kd a.png\nmap_d b.png\n", MtlUse::Full).opacity.map);
  EXPECT_EQ(only("map_d b.png\n", MtlUse::Full).opacity.channel, alpha_or_first);
}

DielectricMaterial glass(std::string_view statements) {
  const Material m = only(statements, MtlUse::Full);
  EXPECT_EQ(m.opacity.factor, 1.0);
  return std::get<DielectricMaterial>(m.model);
}

TEST(Unit_Mtl, FullGlass) {
  const DielectricMaterial thick = glass("illum 7\nNi 1.33\nTf .9 .8 .7\nNs 1000\n");
  EXPECT_EQ(thick.ior, 1.33);
  EXPECT_FALSE(thick.is_thin);
  EXPECT_EQ(thick.transmittance, Vec3d(0.9, 0.8, 0.7));
  EXPECT_EQ(thick.roughness.factor, 0.0);
  // lab3's sports car and sibenik: index 1, a filter.
  const DielectricMaterial thin = glass("illum 4\nNi 1.0\nTf .4 .4 .4\nd 1\nKs .1 .1 .1\n");
  EXPECT_TRUE(thin.is_thin);
  EXPECT_EQ(thin.ior, 1.5);
  EXPECT_EQ(glass("d .3\nNi 1.5\nillum 2\n").transmittance, Vec3d(1.0));
  EXPECT_DOUBLE_EQ(glass("illum 6\nNi 1.5\nNs 6\n").roughness.factor, 0.5);
}

TEST(Unit_Mtl, FullOpaqueMaterialsOfExportersThatWriteIllum4StayOpaque) {
  EXPECT_EQ(lab("illum 4\nKd .5 .5 .5\nTf 1 1 1\nNi 1\n", MtlUse::Full).diffuse.factor, Vec3d(0.5));
  EXPECT_EQ(lab("illum 2\nKd .5 .5 .5\nTf .7 .7 .7\nNi 1\n", MtlUse::Full).diffuse.factor,
            Vec3d(0.5));
  EXPECT_EQ(lab("illum 2\nKd .5 .5 .5\nTf 1 1 1\nNi 1.5\n", MtlUse::Full).diffuse.factor,
            Vec3d(0.5));
  EXPECT_TRUE(lab("illum 4\nmap_Kd a.png\nTf .5 .5 .5\n", MtlUse::Full).diffuse.map);
}

TEST(Unit_Mtl, FullMirrors) {
  const Material m = only("illum 3\nKd 0 0 0\nKs .9 .8 .7\nNi 1\n", MtlUse::Full);
  EXPECT_EQ(std::get<MirrorMaterial>(m.model).reflectance.factor, Vec3d(0.9, 0.8, 0.7));
  EXPECT_EQ(lab("illum 3\nKd .1 0 0\nKs .9 .8 .7\n", MtlUse::Full).specular.factor.x, 0.9);
  EXPECT_EQ(lab("illum 4\nKd 0 0 0\nKs .1 .1 .1\nNs 20\n", MtlUse::Full).specular.factor.x, 0.1);
  EXPECT_EQ(lab("illum 2\nKd 0 0 0\nKs .9 .8 .7\n", MtlUse::Full).specular.factor.x, 0.9);
}

TEST(Unit_Mtl, FullMetalWorkflowConservesEnergyAndKeepsTheReflectance) {
  for (const double metalness : {0.0, 0.25, 0.5, 1.0}) {
    const Material material =
        only(fmt::format("Kd .8 .5 .2\nPr .4\nPm {}\nillum 7\nNi 1.5\n", metalness), MtlUse::Full);
    const auto& m = std::get<CookTorranceMaterial>(material.model);
    EXPECT_DOUBLE_EQ(m.roughness.factor, 0.16);
    const Vec3d base{std::pow(0.8, 2.2), std::pow(0.5, 2.2), std::pow(0.2, 2.2)};
    for (int c = 0; c < 3; ++c) {
      EXPECT_LE(m.diffuse.factor[c] + m.specular.factor[c], 1.0 + 1e-15);
      EXPECT_NEAR(m.diffuse.factor[c], (1 - metalness) * base[c], 1e-15);
      EXPECT_NEAR(m.specular.factor[c] * m.f0[c], 0.04 * (1 - metalness) + metalness * base[c],
                  1e-15);
    }
  }
  const MtlLibrary mapped = parse("newmtl m\nmap_Kd gold.png\nPm 1\nmap_Pr r.png\n", MtlUse::Full);
  const auto& m = std::get<CookTorranceMaterial>(mapped.materials.at(0).model);
  EXPECT_FALSE(m.diffuse.map);
  EXPECT_EQ(mapped.images.at(m.specular.map.index).path, "folder/gold.png");
  EXPECT_EQ(mapped.images.at(m.roughness.map.index).path, "folder/r.png");
}

// A map has no factor: metalness between 0 and 1 counts as the nearer one.
TEST(Unit_Mtl, MapsAreOfMetalsOrOfWhatIsNone) {
  const auto mapped = [](std::string_view metalness) {
    return std::get<CookTorranceMaterial>(
        only(fmt::format("Kd .8 .5 .2\nmap_Kd a.png\nPm {}\n", metalness), MtlUse::Full).model);
  };
  EXPECT_TRUE(mapped(".45").diffuse.map);
  EXPECT_FALSE(mapped(".45").specular.map);
  EXPECT_NEAR(mapped(".45").specular.factor.x * mapped(".45").f0.x, 0.04, 1e-15);
  EXPECT_FALSE(mapped(".55").diffuse.map);
  EXPECT_EQ(mapped(".55").diffuse.factor, Vec3d(0.0));
  EXPECT_TRUE(mapped(".55").specular.map);
  EXPECT_EQ(mapped(".55").f0, Vec3d(1.0));
}

TEST(Unit_Mtl, IgnoreReadsNothing) {
  EXPECT_TRUE(parse("newmtl a\nKd x\n", MtlUse::Ignore).materials.empty());
}

TEST(Unit_Mtl, FullMetalWorkflowKeepsTheAlphaOfItsMap) {
  const auto opacity = [](std::string_view more) {
    return only(fmt::format("map_Kd leaf.png\nPr 1\n{}", more), MtlUse::Full).opacity;
  };
  EXPECT_TRUE(opacity("").map);
  EXPECT_EQ(opacity("").channel, 3);
  EXPECT_EQ(opacity("map_d mask.png\n").map.index, 1u);
  EXPECT_FALSE(opacity("d .5\n").map);
  EXPECT_EQ(opacity("d .5\n").factor, 0.5);
}

}  // namespace
}  // namespace candela::obj
