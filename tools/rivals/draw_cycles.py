"""Draws the job whose file is the argument with Cycles; runs in the Python that has the package bpy (tools/evaluation/rivals.py)."""
import json
import sys
from pathlib import Path

import bpy
import mathutils
import numpy as np


def material_of(surface, nodes, links):
    """Lambert on the front. The back is black, and the camera sees through it."""
    def node(kind, **inputs):
        made = nodes.new(kind)
        for name, value in inputs.items():
            made.inputs[name].default_value = value
        return made
    nodes.clear()
    geometry, path = node("ShaderNodeNewGeometry"), node("ShaderNodeLightPath")
    front = node("ShaderNodeAddShader")
    links.new(node("ShaderNodeBsdfDiffuse", Color=(*surface["albedo"], 1)).outputs[0], front.inputs[0])
    if max(surface["emission"]) > 0:
        links.new(node("ShaderNodeEmission", Color=(*surface["emission"], 1), Strength=1).outputs[0], front.inputs[1])
    back, whole = node("ShaderNodeMixShader"), node("ShaderNodeMixShader")
    links.new(path.outputs["Is Camera Ray"], back.inputs[0])
    links.new(node("ShaderNodeBsdfDiffuse", Color=(0, 0, 0, 1)).outputs[0], back.inputs[1])
    links.new(node("ShaderNodeBsdfTransparent").outputs[0], back.inputs[2])
    links.new(geometry.outputs["Backfacing"], whole.inputs[0])
    links.new(front.outputs[0], whole.inputs[1])
    links.new(back.outputs[0], whole.inputs[2])
    links.new(whole.outputs[0], node("ShaderNodeOutputMaterial").inputs["Surface"])


def add_surface(scene, surface):
    corners = np.array(surface["positions"]).reshape(-1, 3)
    mesh = bpy.data.meshes.new("surface")
    mesh.from_pydata(corners, [], np.arange(len(corners)).reshape(-1, 3))
    mesh.normals_split_custom_set(np.array(surface["normals"]).reshape(-1, 3))
    material = bpy.data.materials.new("surface")
    material.use_nodes = True
    material_of(surface, material.node_tree.nodes, material.node_tree.links)
    mesh.materials.append(material)
    scene.collection.objects.link(bpy.data.objects.new("surface", mesh))


def matrix(axes, position):
    return mathutils.Matrix([[*row, p] for row, p in zip(np.transpose(axes).tolist(), position)] + [[0, 0, 0, 1]])


def add_sun(scene, sun):
    strength = max(sun["irradiance"])
    if strength == 0:
        return
    light = bpy.data.lights.new("sun", "SUN")
    light.energy, light.angle, light.color = strength, 0, [x / strength for x in sun["irradiance"]]
    holder = bpy.data.objects.new("sun", light)
    holder.matrix_world = mathutils.Vector(sun["towards"]).to_track_quat("Z", "Y").to_matrix().to_4x4()
    scene.collection.objects.link(holder)


def main():
    job = json.loads(Path(sys.argv[1]).read_text())
    described, settings = job["scene"], job["settings"]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    for surface in described["surfaces"]:
        add_surface(scene, surface)
    add_sun(scene, described["sun"])
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.angle_y = "VERTICAL", np.radians(described["camera"]["vertical_fov_deg"])
    size = float(np.linalg.norm(np.subtract(*described["bounds"])))
    camera.clip_start, camera.clip_end = 1e-4 * size, 100 * size
    scene.camera = bpy.data.objects.new("camera", camera)
    scene.camera.matrix_world = matrix(described["camera"]["right_up_back"], described["camera"]["eye"])
    scene.collection.objects.link(scene.camera)

    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = "CPU", settings["samples"], False, False
    cycles.pixel_filter_type, cycles.sample_clamp_indirect, cycles.sample_clamp_direct = "BOX", 0, 0
    cycles.max_bounces = cycles.diffuse_bounces = settings["bounces"]
    cycles.transparent_max_bounces = 64
    scene.render.resolution_x, scene.render.resolution_y = described["size"]
    scene.render.resolution_percentage, scene.render.use_persistent_data = 100, False
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.render.filepath = f"{job['out']}/picture.exr"
    bpy.ops.render.render(write_still=True)
    Path(job["out"], "report.json").write_text(json.dumps({"driver": "CPU", "version": bpy.app.version_string}))


main()
