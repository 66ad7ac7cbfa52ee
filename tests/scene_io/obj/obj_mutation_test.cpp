// Broken files neither crash nor hang the OBJ and MTL readers, and what they hand back is sound.
#include <gtest/gtest.h>

#include "scene_io/obj/read_mtl.h"
#include "scene_io/obj/read_obj.h"
#include "tests/scene_io/mutate.h"
#include "tests/scene_io/obj/check_model.h"
#include "tests/scenes/temporary_folder.h"

namespace candela::obj {
namespace {

const std::string obj_sample =
    "# a sample of all that is read\r\nmtllib a.mtl b.mtl\no box\n"
    "v 0 0 0\nv 1 0 0 1\nv 1 1 0 .5 .5 .5\nv 0 1 0\nv 0.5 0.25e0 1e-1\nv -1 .5 +2.\n"
    "vt 0 0\nvt 1 0 0\nvt 1 1\nvt 0\nvn 0 0 1\nvn 0 0 0\nvn 1 2 3\n"
    "usemtl red one\ng a b\ns 1\nf 1/1/1 2/2/1 3/3/2\nf -1 -2 -3 -4\nf 1//1 3//1 4//1 2//1\n"
    "usemtl blue\nf 1/1 2/2 3/3 4/4 5/1 6/2 \\\n 1/3\nl 1 2 3\np 1\ncurv 0 1 1 2\nend\n"
    "g c\nusemtl red one\nf 6 5 4 3 2 1 2 3\n";
const std::string mtl_sample =
    "newmtl red one\nKa 1 1 1\nKd .5 .25 0.125\nKs 1\nNs 300.5\nd 0.5\nTr 0.25\nillum 4\nNi 1.5\n"
    "Tf .9 .9 .9\nKe 1 2 3\nmap_Kd -bm 1 -s 1 1 1 -o 0 0 tex\\a b.png\nmap_Ks s.png\n"
    "newmtl blue\nPr .5\nPm 1\nmap_Bump -bm 0.3 -imfchan r -clamp on h.png\nbump h.png\n"
    "map_d -imfchan m d.png\nnorm n.png\nrefl -type sphere r.png\nmap_Ke e.png\n";

void expect_sound(ObjModel& model, int round, const std::string& text) {
  const std::string fault = fault_of(model);
  ASSERT_EQ(fault, "") << "copy " << round << ":\n" << text;
}

void try_obj_copies(const std::string& sample, MtlUse use, unsigned seed, int count) {
  const TemporaryFolder folder;
  folder.put("a.mtl", mtl_sample);
  ObjOptions options;
  options.materials = use;
  Mutator mutate(seed);
  int unharmed = 0;
  for (int round = 0; round < count; ++round) {
    const std::string text = mutate(sample);
    Diagnostics diagnostics;
    ObjModel model = parse_obj(folder.file("a.obj"), text, options, diagnostics);
    expect_sound(model, round, text);
    if (::testing::Test::HasFatalFailure()) return;
    unharmed += diagnostics.has_errors() ? 0 : 1;
  }
  // Copies that are all refused at once would try nothing.
  EXPECT_GT(unharmed, count / 20);
  EXPECT_LT(unharmed, count - count / 20);
}

TEST(Stress_Obj, MutatedFilesAreHarmless) {
  try_obj_copies(obj_sample, MtlUse::Ignore, 1, mutation_count());
}

TEST(Stress_Obj, MutatedFilesWithMaterialsAreHarmless) {
  try_obj_copies(obj_sample, MtlUse::Full, 2, mutation_count() / 10);
  try_obj_copies(obj_sample, MtlUse::Lab, 3, mutation_count() / 10);
}

TEST(Stress_Obj, MutatedAssetsAreHarmless) {
  for (const std::string name : {"cutouts/pot.obj", "cornell_box/room.obj"}) {
    const std::string text = contents_of(CANDELA_SOURCE_DIR "/assets/" + name);
    ASSERT_FALSE(text.empty()) << name;
    try_obj_copies(text, MtlUse::Ignore, 4, mutation_count() / 20);
  }
}

TEST(Stress_Mtl, MutatedFilesAreHarmless) {
  for (const MtlUse use : {MtlUse::Lab, MtlUse::Full}) {
    Mutator mutate(use == MtlUse::Lab ? 5 : 6);
    for (int round = 0; round < mutation_count() / 2; ++round) {
      const std::string text = mutate(mtl_sample);
      Diagnostics diagnostics;
      MtlLibrary library = parse_mtl("nowhere/a.mtl", text, use, diagnostics);
      ObjModel model;
      model.materials = std::move(library.materials);
      model.images = std::move(library.images);
      expect_sound(model, round, text);
      if (HasFatalFailure()) return;
    }
  }
}

// Each of these would take minutes if a line were counted, or names compared, for each of them.
TEST(Stress_Obj, ManyOddLinesTakeTimeInProportion) {
  const TemporaryFolder folder;
  std::string mtl, obj = "mtllib many.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 30'000; ++i) {
    mtl += fmt::format("newmtl material{}\nodd{} 1\nmap_Kd absent{}.png\nnewmtl again\n", i, i, i);
    obj += fmt::format("usemtl materiel{}\nf 1 2 3\nusemtl material{}\nf 1 3 2\nodd{}\n", i, i, i);
  }
  folder.put("many.mtl", mtl);
  Diagnostics diagnostics;
  ObjModel model = parse_obj(folder.file("a.obj"), obj, {}, diagnostics);
  EXPECT_EQ(model.meshes.size(), 30'000u);
  EXPECT_EQ(model.images.size(), 30'000u);
  EXPECT_EQ(model.materials.at(20'000).span.line, 40'001u);
  EXPECT_EQ(model.meshes.at(7).span.line, 4 + 7 * 5 + 4u);
  EXPECT_EQ(diagnostics.list().size(), Diagnostics::limit);
  EXPECT_EQ(fault_of(model), "");
}

TEST(Stress_Obj, RandomBytesAreHarmless) {
  std::mt19937 random(9);
  for (int round = 0; round < 200; ++round) {
    std::string bytes(5000, '\0');
    for (char& c : bytes)
      c = static_cast<char>(round % 2 == 0 ? random() : " \nfv/-0123.\\\r#"[random() % 15]);
    Diagnostics diagnostics;
    ObjOptions options;
    options.materials = MtlUse::Ignore;
    ObjModel model = parse_obj("nowhere/a.obj", bytes, options, diagnostics);
    expect_sound(model, round, bytes);
  }
}

}  // namespace
}  // namespace candela::obj
