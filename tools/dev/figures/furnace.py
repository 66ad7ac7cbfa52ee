"""How much light rough metal loses: a white metal ball in white light from everywhere."""

import plots
from exr import read_exr
from renders import square
from scenes import ASSETS
from workshop import SEED, figure

# From so far that all rays are nearly parallel: the ball's mean radiance is then the mean albedo
# over the hemisphere, weighted by the cosine.
SCENE = """\
Cameras:
  - Eye: [0, 0, 100]
    Target: [0, 0, 0]
    Fovy: 1.2
Environment:
  Radiance: 1
  VisibleToCamera: false
Materials:
  - Name: ball
    {material}
Models:
  - Mesh: sphere.obj
    Material: ball
"""

# Key of the table, name, how the material is written.
METALS = (
    ("single", "one bounce between microfacets", "geometry: smith"),
    ("compensated", "with energy_compensation",
     "geometry: smith\n    energy_compensation: true"),
    ("schlick_ggx", "one bounce, the report's G", "geometry: schlick_ggx"),
)


def make(workshop):
    folder = workshop.out / "furnace"
    folder.mkdir(parents=True, exist_ok=True)
    mesh = ASSETS / "glass_and_metal" / "sphere.obj"
    (folder / "sphere.obj").write_bytes(mesh.read_bytes())
    white = total(render(workshop, folder, "white", "Type: diffuse\n    kd: 1"))
    rows = [{"caption": f"{roughness:g}",
             **{key: total(metal(workshop, folder, key, roughness, geometry)) / white
                for key, _, geometry in METALS}}
            for roughness in workshop.scale.roughness]
    path = workshop.plot("furnace")
    plots.line_plot(path, [(name, workshop.scale.roughness, [r[key] for r in rows], {})
                           for key, name, _ in METALS], "roughness", "light given back")
    return figure(
        "furnace", "What rough metal loses",
        ["A ball of metal that reflects everything (F0 = 1), in a white furnace: it should give "
         "back all light. A microfacet model that follows one bounce loses what bounces between "
         "the microfacets; energy_compensation puts it back. Means over the ball, relative to a "
         "white diffuse one, by roughness. docs/scene_format.md, materials with a type."],
        [(key, name) for key, name, _ in METALS],
        rows, [(workshop.relative(path), "Light given back against roughness.")])


def metal(workshop, folder, key, roughness, geometry):
    return render(workshop, folder, f"{key}_{roughness:g}",
                  f"Type: cook_torrance\n    kd: 0\n    ks: 1\n    F0: 1\n"
                  f"    roughness: {roughness}\n    {geometry}")


def render(workshop, folder, name, material):
    scene = folder / f"{name}.yaml"
    scene.write_text(SCENE.format(material=material))
    scale = workshop.scale
    return workshop.candela.render(f"furnace_{name}", scene, spp=scale.furnace_spp, seed=SEED,
                                   size=square(scale.furnace_size))


def total(render_of_ball):
    return float(read_exr(render_of_ball.exr).sum())
