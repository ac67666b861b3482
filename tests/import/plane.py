"""The plane under the lights of a Blender scene, rendered by Cycles: for the scripts that compare it with gonio probe."""

import math
import os
import tempfile

import bpy

pixels = 32
width = 4.0  # of the square that is looked at [m]


def render_plane(out, samples, eye_height):
    """Renders z = -1 from above and writes x, y in metres and lux, which are Blender's W/m2 times 177.83, the lumens that
    it counts for a watt of an IES profile."""
    white = bpy.data.materials.new("white")
    white.use_nodes = True
    nodes = white.node_tree.nodes
    nodes.clear()
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    surface = nodes.new("ShaderNodeOutputMaterial")
    white.node_tree.links.new(diffuse.outputs[0], surface.inputs["Surface"])
    mesh = bpy.data.meshes.new("plane")
    half = width
    mesh.from_pydata([(-half, -half, -1), (half, -half, -1), (half, half, -1), (-half, half, -1)], [], [(0, 1, 2, 3)])
    mesh.materials.append(white)
    scene = bpy.context.scene
    scene.collection.objects.link(bpy.data.objects.new("plane", mesh))

    eye = bpy.data.cameras.new("eye")
    eye.type = "ORTHO"
    eye.ortho_scale = width
    camera = bpy.data.objects.new("eye", eye)
    camera.location = (0.0, 0.0, eye_height)
    scene.collection.objects.link(camera)
    scene.camera = camera

    scene.world = bpy.data.worlds.new("dark")
    scene.world.color = (0.0, 0.0, 0.0)
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0
    scene.cycles.pixel_filter_type = "BOX"
    scene.render.resolution_x = scene.render.resolution_y = pixels
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = os.path.join(folder, "plane.exr")
        bpy.ops.render.render(write_still=True)
        picture = bpy.data.images.load(scene.render.filepath)
        values = list(picture.pixels)

    with open(out, "w", encoding="ascii") as table:
        table.write("x,y,lux\n")
        for row in range(pixels):  # from below
            for column in range(pixels):
                red, green, blue = values[4 * (row * pixels + column) :][:3]
                luminance = 0.21263900587151027 * red + 0.71516867876775592 * green + 0.072192315360733714 * blue
                x = ((column + 0.5) / pixels - 0.5) * width
                y = ((row + 0.5) / pixels - 0.5) * width
                table.write(f"{x},{y},{luminance * math.pi * 177.83}\n")
