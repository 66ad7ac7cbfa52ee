"""Renders with Cycles what a JSON file asks for. Blender runs this, not Python:

    blender -b --factory-startup --python-exit-code 1 -P render_in_cycles.py -- JOBS.json

JOBS.json: {"threads": n, "scenes": {name: what blender_scene.read() gives}, "renders": [...],
"settings": {name: value}}; each render has scene, exr and what cycles_renders.Job has; settings are
of scene.cycles and go before PLAIN's. Everything that Cycles would do to a picture beside tracing
paths is off. Prints the CPU seconds of each render, with its synchronization and its file.
"""

import json
import math
import pathlib
import sys
import time

import bpy
import mathutils
import numpy

sys.dont_write_bytecode = True
sys.path.append(str(pathlib.Path(__file__).parent))

import cycles_materials  # noqa: E402
import equal_area  # noqa: E402

# Of scene.cycles. Versions differ in what they know; each takes what it has.
PLAIN = {
    "use_denoising": False, "sample_clamp_direct": 0, "sample_clamp_indirect": 0,
    "light_sampling_threshold": 0, "blur_glossy": 0, "caustics_reflective": True,
    "caustics_refractive": True, "use_fast_gi": False, "use_guiding": False, "use_auto_tile": False,
    "pixel_filter_type": "BOX", "film_exposure": 1, "time_limit": 0, "device": "CPU",
    "diffuse_bounces": 100, "glossy_bounces": 100, "transmission_bounces": 100,
    "transparent_max_bounces": 100, "min_light_bounces": 0, "min_transparent_bounces": 0,
    "use_light_tree": False,
}


def main():
    with open(sys.argv[sys.argv.index("--") + 1]) as file:
        jobs = json.load(file)
    made = None
    for render in sorted(jobs["renders"], key=lambda render: render["scene"]):
        if render["scene"] != made:
            make_scene(jobs["scenes"][render["scene"]], jobs["threads"], jobs["settings"])
            made = render["scene"]
        start = time.process_time()
        render_one(render)
        print(f"CPU seconds: {time.process_time() - start:.6f}", flush=True)


def render_one(render):
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = render["width"], render["height"]
    scene.render.filepath = render["exr"]
    scene.cycles.samples, scene.cycles.seed = render["spp"], render["seed"]
    scene.cycles.sample_offset = render["first_sample"]
    scene.cycles.max_bounces = render["bounces"]
    threshold = render["noise_threshold"]
    scene.cycles.use_adaptive_sampling = threshold is not None
    if threshold is not None:
        scene.cycles.adaptive_threshold = threshold
        scene.cycles.adaptive_min_samples = 0  # by Cycles' own rule
    # The share of the samples that each pixel took.
    bpy.context.view_layer.cycles.pass_debug_sample_count = threshold is not None
    bpy.ops.render.render(write_still=True)


def make_scene(description, threads, settings):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.world = None
    plain_settings(scene, threads, settings)
    for index, mesh in enumerate(description["meshes"]):
        add_mesh(f"{index}_{mesh['name']}", mesh)
    for light in description["lights"]:
        add_light(light)
    if description["environment"]:
        scene.world = world(description["environment"])
    scene.camera = camera(description["camera"])


def plain_settings(scene, threads, settings):
    scene.render.engine = "CYCLES"
    for name, value in (PLAIN | settings).items():
        if hasattr(scene.cycles, name):
            setattr(scene.cycles, name, value)
    scene.render.threads_mode, scene.render.threads = "FIXED", threads
    scene.render.resolution_percentage = 100
    scene.render.film_transparent = False
    scene.render.use_compositing = scene.render.use_sequencer = False
    # Meshes and skies stay as they are from picture to picture of a scene: what that takes is no
    # noise of the CPU time.
    scene.render.use_persistent_data = True
    scene.render.dither_intensity = 0
    output = scene.render.image_settings
    output.file_format, output.color_depth, output.exr_codec = "OPEN_EXR_MULTILAYER", "32", "ZIP"


def linked(name, data):
    thing = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(thing)
    return thing


def camera(description):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle = description["fovy"]
    matrix = mathutils.Matrix(description["to_world"])
    # Nothing between the eye and the scene is to be clipped, nor the far end of a large scene.
    data.clip_start, data.clip_end = 1e-4, 1e6
    thing = linked("camera", data)
    thing.matrix_world = matrix
    return thing


def add_mesh(name, description):
    corners = [corner for triangle in description["corners"] for corner in triangle]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], [(i, i + 1, i + 2) for i in range(0, len(corners), 3)])
    if "uvs" in description:
        mesh.uv_layers.new(do_init=False).data.foreach_set("uv", [
            x for triangle in description["uvs"] for uv in triangle for x in uv])
    if description["normals"]:
        for polygon in mesh.polygons:
            polygon.use_smooth = True
        if hasattr(mesh, "use_auto_smooth"):  # until Blender 4.1
            mesh.use_auto_smooth = True
        mesh.normals_split_custom_set([n for triangle in description["normals"] for n in triangle])
    mesh.materials.append(cycles_materials.material(name, description))
    for to_world in description["instances"] or [None]:
        thing = linked(name, mesh)
        if to_world is not None:
            thing.matrix_world = mathutils.Matrix(to_world)
        # These move shadows and shading on smooth meshes.
        thing.cycles.shadow_terminator_geometry_offset = thing.cycles.shadow_terminator_offset = 0


def add_light(description):
    """A point of P watts has the radiant intensity P / (4 pi); a sun's energy is its irradiance.
    With a radius a point is a ball, until Blender 4.1 a disk that faces whoever looks."""
    kind, radius = description["type"], description.get("radius", 0)
    data = bpy.data.lights.new("light", kind)
    if kind == "POINT":
        strength = [4 * math.pi * x for x in description["radiant_intensity"]]
        data.shadow_soft_size = radius
    else:
        strength = description["irradiance"]
        data.angle = 0
    data.energy = max(strength)
    if data.energy > 0:
        data.color = [x / data.energy for x in strength]
    if hasattr(data.cycles, "max_bounces"):
        data.cycles.max_bounces = 1024
    thing = linked("light", data)
    thing.visible_camera = radius > 0
    if kind == "POINT":
        thing.location = description["position"]
    else:  # a sun shines along its -z
        thing.rotation_mode = "QUATERNION"
        thing.rotation_quaternion = mathutils.Vector(description["towards"]).to_track_quat("Z", "Y")


def world(description):
    result = bpy.data.worlds.new("world")
    result.use_nodes = True
    tree = result.node_tree
    tree.nodes.clear()
    new, link = tree.nodes.new, tree.links.new
    if description["map"] is None:
        background, output = new("ShaderNodeBackground"), new("ShaderNodeOutputWorld")
        background.inputs["Color"].default_value = (*description["scale"], 1)
        link(background.outputs["Background"], output.inputs["Surface"])
        return result
    coordinates, mapping = new("ShaderNodeTexCoord"), new("ShaderNodeMapping")
    texture, scale = new("ShaderNodeTexEnvironment"), new("ShaderNodeVectorMath")
    background, output = new("ShaderNodeBackground"), new("ShaderNodeOutputWorld")
    texture.image = bpy.data.images.load(description["map"])
    texture.image.colorspace_settings.name = "Non-Color"  # linear, as it stands
    if "map_from_world" in description:
        texture.image = as_lat_long(texture.image, description["map_from_world"])
    else:
        mapping.inputs["Rotation"].default_value = (0, 0, -description["turn"])
    scale.operation = "MULTIPLY"
    scale.inputs[1].default_value = description["scale"]
    link(coordinates.outputs["Generated"], mapping.inputs["Vector"])
    link(mapping.outputs["Vector"], texture.inputs["Vector"])
    link(texture.outputs["Color"], scale.inputs[0])
    link(scale.outputs["Vector"], background.inputs["Color"])
    link(background.outputs["Background"], output.inputs["Surface"])
    # Where to look for light. Left to itself, Cycles takes 4096 columns and 3 seconds a picture.
    result.cycles.sampling_method, result.cycles.sample_map_resolution = "MANUAL", 512
    return result


def as_lat_long(image, map_from_world):
    """What Cycles can look up, of an image of equal areas."""
    width, height = image.size
    pixels = numpy.empty(4 * width * height, numpy.float32)
    image.pixels.foreach_get(pixels)
    found = equal_area.lat_long(pixels.reshape(height, width, 4)[::-1], map_from_world)
    result = bpy.data.images.new("sky", found.shape[1], found.shape[0], float_buffer=True,
                                 is_data=True)
    result.pixels.foreach_set(found[::-1].astype(numpy.float32).ravel())  # rows from the bottom
    return result


main()
