"""Every scene that is here on one page: picture, reference beside it, time, spp, stated error."""

import html
import json
import sys
import time

import scenes
from page import numbers
from page_parts import page_of, picture
from reference_pictures import Reference, write_png

SEED = 1
COLUMNS = (("width", "width"), ("height", "height"), ("triangles", "triangles"), ("spp", "spp"),
           ("preparation", "seconds to read and build"), ("seconds", "seconds to render"),
           ("stated_rmse", "stated error (rMSE)"), ("heavy_tails", "share with heavy tails"),
           ("of_reference", "mean of the reference's"))
ABOUT = """\
<p>Rendered by <code>path</code> in one run, with the reference beside it where there is one:
pbrt-v4's picture of the same file, or the picture that the course's own ray tracer made, which
follows mirrors only. Seconds are of a machine that may have had other work; the error is the one
that candela states from the picture alone, and not to be trusted in the share of pixels with heavy
tails.</p>"""
PAIRS = """
.pairs { display: grid; gap: 1.5rem; grid-template-columns: repeat(auto-fill, minmax(20rem, 1fr)); }
.pair { display: grid; gap: .5rem; grid-template-columns: 1fr 1fr; align-items: start; }
.pair h2 { grid-column: 1 / -1; font-size: 1rem; margin: 0; }
.pair img { image-rendering: pixelated; }
"""


def picture_size(candela, scene, longest):
    """The scene's own proportions; what it asks for is in the statistics of a single pixel."""
    probe = candela.render("probe", scene, png=False, spp=1, crop="0,0,1,1", replicates=1).stats
    scale = longest / max(probe["width"], probe["height"])
    return tuple(max(1, round(probe[side] * scale)) for side in ("width", "height"))


def row(candela, out, name, scene, reference, options):
    """One scene's line; `reference` may be None."""
    size = options.size and picture_size(candela, scene, options.size)
    if not size:
        size = reference.size if reference and reference.is_linear else \
            picture_size(candela, scene, 192)
    render = candela.render(name.replace("/", "_"), scene, spp=options.spp, seed=SEED,
                            size="{}x{}".format(*size))
    stats = render.stats
    error = stats["error"] or {"rmse": None, "heavy_tails": None}
    line = {"caption": name, "picture": str(render.png.relative_to(out)),
            "stats": str(render.exr.with_suffix(".json").relative_to(out)),
            "width": stats["width"], "height": stats["height"], "triangles": stats["triangles"],
            "spp": render.spp, "seconds": render.seconds,
            "preparation": sum(stats["seconds"][stage] for stage in ("load", "compile", "build")),
            "stated_rmse": error["rmse"], "heavy_tails": error["heavy_tails"],
            "of_reference": None}
    if reference:
        png = out / "references" / (name.replace("/", "_") + ".png")
        write_png(png, reference.encoded())
        line |= {"reference": str(png.relative_to(out)), "reference_by": reference.by,
                 "of_reference": reference.ratio(render.exr)}
    return line


def scenes_here():
    """name -> (file, reference or None): ours, then the course's and pbrt's where they are."""
    folder = scenes.shared_folder()
    found = {path.stem: (path, None) for path in scenes.assets()}
    found |= {name: (path, None) for name, path in scenes.shipped_pbrt_scenes().items()}
    for path in scenes.course_scenes():
        found[f"lab3/{path.stem}"] = (path, Reference.of_course(folder, path.stem))
    for name, path in scenes.pbrt_scenes().items():
        found[name] = (path, Reference.of_pbrt(path.parent))
    return found


def pair(out, line):
    parts = [f'<div class="pair"><h2>{html.escape(line["caption"])}</h2>',
             picture(out, line["picture"], "candela")]
    if "reference" in line:
        parts.append(picture(out, line["reference"], line["reference_by"]))
    return "".join(parts + ["</div>"])


def page(out, record):
    """`record`: what gallery.json holds."""
    facts = {key: value for key, value in record.items() if key != "rows"}
    parts = ['<div class="pairs">', *(pair(out, line) for line in record["rows"]), "</div>",
             numbers("rows", COLUMNS, record["rows"])]
    return page_of("gallery", "All scenes that are here", facts, parts, [ABOUT], PAIRS)


def make(candela, out, options, facts):
    """Writes index.html and gallery.json into `out`; `facts` go into both."""
    start = time.monotonic()
    rows = []
    for name, (scene, reference) in scenes_here().items():
        if options.scene and name not in options.scene:
            continue
        rows.append(row(candela, out, name, scene, reference, options))
        print(f"tools/figures: {name}: {rows[-1]['seconds']:.1f} s", file=sys.stderr)
    record = facts | {"rows": rows, "seconds": round(time.monotonic() - start, 1)}
    (out / "gallery.json").write_text(json.dumps(record, indent=1, allow_nan=False) + "\n")
    (out / "index.html").write_text(page(out, record))
    return out / "index.html"
