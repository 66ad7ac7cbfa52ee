"""Cycles' nodes of what blender_scene.read() and pbrt_scene.read() say of a mesh's material."""

import bpy


def material(name, description):
    result = bpy.data.materials.new(name)
    result.use_nodes = True
    tree = result.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    if not any(description["emission"]):
        surface = SURFACES[description["surface"]](tree, description)
    elif description["albedo"] != [0, 0, 0]:
        raise ValueError(f"{name}: a lamp that also reflects is not compared")
    else:
        surface = emission(tree, description)
    tree.links.new(surface.outputs[0], output.inputs["Surface"])
    if "absorption" in description:
        volume = absorption(tree, description["absorption"])
        tree.links.new(volume.outputs[0], output.inputs["Volume"])
    return result


def emission(tree, description):
    """Cycles' meshes shine from both sides; nothing is mixed in where their back is seen."""
    shine = tree.nodes.new("ShaderNodeEmission")
    shine.inputs["Color"].default_value = (*description["emission"], 1)
    shine.inputs["Strength"].default_value = 1
    if description["two_sided"]:
        return shine
    geometry, mix = tree.nodes.new("ShaderNodeNewGeometry"), tree.nodes.new("ShaderNodeMixShader")
    tree.links.new(geometry.outputs["Backfacing"], mix.inputs["Fac"])
    tree.links.new(shine.outputs[0], mix.inputs[1])
    return mix


def absorption(tree, of_length):
    """Cycles absorbs (1 - colour) * density of a length."""
    node = tree.nodes.new("ShaderNodeVolumeAbsorption")
    density = max(of_length)
    if density > 0:
        node.inputs["Color"].default_value = (*(1 - x / density for x in of_length), 1)
    node.inputs["Density"].default_value = density
    return node


def diffuse(tree, description):
    node = tree.nodes.new("ShaderNodeBsdfDiffuse")
    give(tree, description["albedo"], node.inputs["Color"])
    node.inputs["Roughness"].default_value = 0
    return node


def glossy(tree, description):
    return microfacets(tree, "ShaderNodeBsdfGlossy", description)


def glass(tree, description):
    node = microfacets(tree, "ShaderNodeBsdfGlass", description)
    node.inputs["IOR"].default_value = description["ior"]
    return node


def microfacets(tree, kind, description):
    node = tree.nodes.new(kind)
    give(tree, description["albedo"], node.inputs["Color"])
    roughness = description.get("roughness", 0)
    node.inputs["Roughness"].default_value = roughness
    node.distribution = "GGX" if roughness else "SHARP"
    return node


def metal(tree, description):
    """Its colour is that of light from straight above; at grazing angles it is white."""
    node = tree.nodes.new("ShaderNodeBsdfPrincipled")
    node.distribution = "GGX"
    give(tree, description["albedo"], node.inputs["Base Color"])
    node.inputs["Metallic"].default_value = 1
    node.inputs["Roughness"].default_value = description["roughness"]
    if "bump" in description:
        bump = tree.nodes.new("ShaderNodeBump")
        bump.inputs["Distance"].default_value = description["bump"]["height"]
        give(tree, description["bump"]["texture"], bump.inputs["Height"])
        tree.links.new(bump.outputs["Normal"], node.inputs["Normal"])
    return node


def coated(tree, description):
    """A diffuse surface of which Fresnel's term at the normal lets out a part, and a reflection."""
    below = tree.nodes.new("ShaderNodeBsdfDiffuse")
    give(tree, description["albedo"], below.inputs["Color"])
    if "coat" in description:
        under_coat(tree, below.inputs["Color"], description["coat"])
    let_out, both = tree.nodes.new("ShaderNodeMixShader"), tree.nodes.new("ShaderNodeAddShader")
    tree.links.new(fresnel(tree, description["ior"]).outputs[0], let_out.inputs["Fac"])
    tree.links.new(below.outputs[0], let_out.inputs[1])
    tree.links.new(let_out.outputs[0], both.inputs[0])
    tree.links.new(reflection(tree, description).outputs[0], both.inputs[1])
    return both


def reflection(tree, description):
    """A dielectric's outer one alone, by the Fresnel term of each microfacet."""
    node = tree.nodes.new("ShaderNodeBsdfPrincipled")
    node.distribution = "GGX"
    node.inputs["Base Color"].default_value = (0, 0, 0, 1)
    node.inputs["Roughness"].default_value = description["roughness"]
    straight_on = ((description["ior"] - 1) / (description["ior"] + 1)) ** 2
    # Until Blender 4, which knows the index itself.
    name = "Specular" if "Specular" in node.inputs else "Specular IOR Level"
    node.inputs[name].default_value = straight_on / .08
    return node


def under_coat(tree, colour, coat):
    """Of the colour that an input has: through * colour / (1 - back * colour)."""
    lost, rest, sent, quotient = (tree.nodes.new("ShaderNodeVectorMath") for _ in range(4))
    source = colour.links[0].from_socket
    for node, operation, factor in ((lost, "MULTIPLY", coat["back"]),
                                    (sent, "MULTIPLY", coat["through"])):
        node.operation = operation
        node.inputs[1].default_value = [factor] * 3
        tree.links.new(source, node.inputs[0])
    rest.operation, quotient.operation = "SUBTRACT", "DIVIDE"
    rest.inputs[0].default_value = [1] * 3
    tree.links.new(lost.outputs[0], rest.inputs[1])
    tree.links.new(sent.outputs[0], quotient.inputs[0])
    tree.links.new(rest.outputs[0], quotient.inputs[1])
    tree.links.new(quotient.outputs[0], colour)


def fresnel(tree, ior):
    """Of both sides alike: Blender takes 1 / IOR for what is seen from behind."""
    geometry, index = tree.nodes.new("ShaderNodeNewGeometry"), tree.nodes.new("ShaderNodeMath")
    node = tree.nodes.new("ShaderNodeFresnel")
    index.operation = "MULTIPLY_ADD"
    tree.links.new(geometry.outputs["Backfacing"], index.inputs[0])
    index.inputs[1].default_value, index.inputs[2].default_value = 1 / ior - ior, ior
    tree.links.new(index.outputs[0], node.inputs["IOR"])
    return node


def give(tree, value, to):
    """A colour as it stands or a texture."""
    if isinstance(value, dict):
        tree.links.new(texture(tree, value).outputs["Color"], to)
    else:
        to.default_value = (*value, 1)


def texture(tree, description):
    coordinates, scaled = (tree.nodes.new(kind) for kind in ("ShaderNodeUVMap",
                                                            "ShaderNodeVectorMath"))
    scaled.operation = "MULTIPLY"
    scaled.inputs[1].default_value = (*description["uv_scale"], 0)
    tree.links.new(coordinates.outputs["UV"], scaled.inputs[0])
    if "checks" in description:
        node = tree.nodes.new("ShaderNodeTexChecker")
        # What touches the origin has Blender's second colour and pbrt's first.
        at_origin, beside = description["checks"]
        node.inputs["Color1"].default_value = (*beside, 1)
        node.inputs["Color2"].default_value = (*at_origin, 1)
        node.inputs["Scale"].default_value = 1
    else:
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image = bpy.data.images.load(description["image"], check_existing=True)
        node.image.colorspace_settings.name = description["colour_space"]
        node.extension = description["beyond"]
    tree.links.new(scaled.outputs["Vector"], node.inputs["Vector"])
    return node


SURFACES = {"diffuse": diffuse, "glossy": glossy, "glass": glass, "metal": metal, "coated": coated}
