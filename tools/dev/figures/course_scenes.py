"""What the report could not make: the course's larger scenes, path traced."""

from renders import square
from workshop import SEED, figure, row

# The two that the report says can be rendered in reasonable time.
SMALL = ("cornell_box", "floor")


def make(workshop, scenes):
    scenes = [s for s in scenes if s.stem not in SMALL]
    rows = []
    for scene in scenes:
        options = {"size": square(workshop.scale.course_size), "seed": SEED}
        for integrator, spp in (("whitted", 1), ("path", workshop.scale.course_spp)):
            render = workshop.candela.render(f"course_{scene.stem}_{integrator}", scene,
                                             integrator=integrator, spp=spp, **options)
            seconds = render.stats["seconds"]
            rows.append(row(workshop, render, f"{scene.stem}, {integrator}",
                            triangles=render.stats["triangles"],
                            preparation=seconds["load"] + seconds["compile"] + seconds["build"]))
    absent = [] if scenes else [
        "No such scene is here: they belong to the course and are not part of this repository. "
        "CANDELA_SCENES names the folder that holds them as lab3/NAME/NAME.yaml."]
    return figure(
        "course_scenes", "What the report could not make: the larger scenes of lab 3",
        ["The report: but for cornell_box and floor, path tracing takes too long. Here they are, "
         "by the lab's ray tracing and path traced.", *absent],
        [("triangles", "triangles"), ("spp", "spp"), ("preparation", "seconds to read and build"),
         ("seconds", "seconds to render")], rows)
