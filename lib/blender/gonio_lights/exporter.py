"""File > Export > Photometric rig: the scene's lights as gonio.rig/1."""

import json
import math
import os

import bpy
from bpy_extras.io_utils import ExportHelper

from . import luminaire

lumens_per_watt = 177.83  # Blender's own figure, which its IES node counts by
rec709_luminance = (0.21263900587151027, 0.71516867876775592, 0.072192315360733714)


def rounded(values):
    return [round(value, 9) + 0.0 for value in values]


def placement(thing, unit_m):
    """Position [m], direction and up of a light, which shines along its −Z."""
    matrix = thing.matrix_world
    axes = matrix.to_3x3().normalized()
    return {
        "position": rounded(value * unit_m for value in matrix.translation),
        "direction": rounded(-axes.col[2]),
        "up": rounded(axes.col[1]),
    }


def colored(color):
    """A colour as a chromaticity, and the factor on the amount that its luminance is."""
    luminance = sum(weight * channel for weight, channel in zip(rec709_luminance, color))
    if luminance <= 0.0:
        return None, 0.0
    return "rgb({:.9g},{:.9g},{:.9g})".format(*(channel / luminance for channel in color)), luminance


def measured(root, folder, unit_m):
    settings = root.gonio
    file = os.path.relpath(bpy.path.abspath(settings.file), folder).replace(os.sep, "/")
    light = {
        "name": root.name,
        "shape": f"ies:{file}" + (",opening" if settings.has_opening else ""),
        "intensity": f"{settings.lumens:.9g}lm",
    }
    if settings.has_kelvin:
        light["color"] = f"{settings.kelvin:.9g}K"
    return {**light, **placement(root, unit_m)}


def own(thing, unit_m, losses):
    """One of Blender's own lights; None if it cannot be expressed."""
    data = thing.data
    color, luminance = colored(data.color)
    scale = [value * unit_m for value in thing.matrix_world.to_scale()]
    lumens = data.energy * luminance * lumens_per_watt  # of a watt as Cycles counts it
    if data.use_nodes:
        losses.append(f"{thing.name}: its nodes are left out")
    if not color or lumens <= 0.0:
        losses.append(f"{thing.name}: is dark and is left out")
        return None
    if data.type == "SUN":
        shape, intensity = f"sun:angle={math.degrees(data.angle):.9g}deg", f"{lumens:.9g}lx"
    elif data.type == "AREA":
        x = data.size * scale[0]
        y = (data.size_y if data.shape in {"RECTANGLE", "ELLIPSE"} else data.size) * scale[1]
        if data.shape in {"SQUARE", "RECTANGLE"}:
            shape, area = f"rect:w={x:.9g}m,h={y:.9g}m", x * y
        else:
            shape, area = f"ellipse:w={x:.9g}m,h={y:.9g}m", math.pi / 4.0 * x * y
        # P watts of an area have the radiance P/4A of a rectangle's, P/4A of an ellipse's own area.
        intensity = f"{lumens / (4.0 * area):.9g}nt"
    else:
        radius = data.shadow_soft_size * unit_m
        candela = lumens / (4.0 * math.pi)
        if data.type == "SPOT":
            outer = math.degrees(data.spot_size) / 2.0
            shape = f"spot:outer={outer:.9g}deg,inner={outer * (1.0 - data.spot_blend):.9g}deg"
            losses.append(f"{thing.name}: the edge of a spot is not quite Blender's, nor is its radius kept")
            intensity = f"{candela:.9g}cd"
        elif radius > 0.0:
            shape = f"sphere:r={radius:.9g}m"
            intensity = f"{candela / (math.pi * radius * radius):.9g}nt"
        else:
            shape, intensity = "point", f"{candela:.9g}cd"
    return {"name": thing.name, "shape": shape, "intensity": intensity, "color": color, **placement(thing, unit_m)}


def rig_of(scene, folder):
    """The rig, and a sentence for everything that it loses."""
    unit_m = scene.unit_settings.scale_length
    lights, losses = [], []
    for thing in sorted(scene.objects, key=lambda thing: thing.name):
        if thing.hide_render:
            continue
        root = luminaire.luminaire_of(thing)
        if root is not None:
            if thing == root:
                lights.append(measured(root, folder, unit_m))
        elif thing.type == "LIGHT":
            light = own(thing, unit_m, losses)
            if light:
                lights.append(light)
    return {"schema": "gonio.rig/1", "lights": lights}, losses


class ExportPhotometricRig(bpy.types.Operator, ExportHelper):
    """The scene's lights as a rig, which gonio probes, previews and imports into other programs"""

    bl_idname = "export_scene.photometric_rig"
    bl_label = "Export photometric rig"

    filename_ext = ".json"
    filter_glob: bpy.props.StringProperty(default="*.json", options={"HIDDEN"})

    def execute(self, context):
        rig, losses = rig_of(context.scene, os.path.dirname(os.path.abspath(self.filepath)))
        if not rig["lights"]:
            self.report({"ERROR"}, "the scene has no lights that a rig can hold")
            return {"CANCELLED"}
        try:
            with open(self.filepath, "w", encoding="utf-8") as file:
                json.dump(rig, file, indent=2, ensure_ascii=False)
                file.write("\n")
        except OSError as error:
            self.report({"ERROR"}, f"{self.filepath}: cannot be written: {error.strerror}")
            return {"CANCELLED"}
        for loss in losses:
            self.report({"WARNING"}, loss)
        return {"FINISHED"}


def menu(self, context):
    self.layout.operator(ExportPhotometricRig.bl_idname, text="Photometric rig (.json)")


def register():
    bpy.utils.register_class(ExportPhotometricRig)
    bpy.types.TOPBAR_MT_file_export.append(menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(menu)
    bpy.utils.unregister_class(ExportPhotometricRig)
