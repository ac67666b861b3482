"""File > Import > Photometric light: profiles as lights for Cycles."""

import json
import os
import tempfile

import bpy
from bpy_extras.io_utils import ImportHelper

from . import luminaire, tool


def color_temperature(info):
    """That of the first lamp that states one [K]; None without."""
    for lamp in info.get("lamps") or []:
        if lamp.get("cct_K"):
            return float(lamp["cct_K"])
    return None


def import_profile(path, size, location, unit_m):
    """Makes the lights of a profile and gives them the settings of luminaire.py. Returns the object to move."""
    info = tool.run_json("info", path)
    opening = (info.get("luminous_opening") or {}).get("shape", "point")
    has_opening = size == "OPENING" and opening != "point"
    name = os.path.splitext(os.path.basename(path))[0]
    with tempfile.TemporaryDirectory() as folder:
        # By a link of a plain name, since the grammar of shapes gives commas a meaning.
        plain = "profile" + os.path.splitext(path)[1].lower()
        try:
            os.symlink(path, os.path.join(folder, plain))
        except OSError:
            plain = path
        shape = f"ies:{plain},opening" if has_opening else f"ies:{plain},opening=off"
        with open(os.path.join(folder, "light.json"), "w", encoding="utf-8") as rig:
            json.dump({"schema": "gonio.rig/1", "lights": [{"name": name, "shape": shape}]}, rig)
        tool.run("import", "light.json", "--to", "blender", "-O", ".", "-q", "--allow-outside", "--unit-scale",
                 f"{unit_m}m", folder=folder)
        script = os.path.join(folder, "blender", "light.py")
        before = set(bpy.data.objects)
        with open(script, encoding="ascii") as source:
            exec(compile(source.read(), script, "exec"), {"__name__": "gonio_light", "__file__": script})
    made = [thing for thing in bpy.data.objects if thing not in before]
    root = next(thing for thing in made if thing.parent is None)
    root.location = location
    root.name = name  # with the characters that the names of scripts have not
    for light in luminaire.lights_of(root):
        light["gonio_watts"] = light.energy
    settings = root.gonio
    settings.file = path
    settings.has_opening = has_opening
    settings.measured_lm = info["flux_lm"]
    settings.lumens = info["flux_lm"]
    kelvin = color_temperature(info)
    if kelvin:
        settings.kelvin = kelvin
        settings.has_kelvin = True
    return root


class ImportPhotometricLight(bpy.types.Operator, ImportHelper):
    """Measured profiles (IES, EULUMDAT, TM-33) as lights for Cycles"""

    bl_idname = "import_scene.photometric_light"
    bl_label = "Import photometric lights"
    bl_options = {"REGISTER", "UNDO"}

    filter_glob: bpy.props.StringProperty(default="*.ies;*.ldt;*.xml", options={"HIDDEN"})
    files: bpy.props.CollectionProperty(type=bpy.types.OperatorFileListElement, options={"HIDDEN", "SKIP_SAVE"})
    directory: bpy.props.StringProperty(subtype="DIR_PATH", options={"HIDDEN", "SKIP_SAVE"})
    size: bpy.props.EnumProperty(
        name="Size",
        items=(
            ("OPENING", "Luminous opening", "Shine from the opening that the file declares: right close to it, too"),
            ("POINT", "Point", "Shine from a point: right from five times its size on"),
        ),
        default="OPENING",
    )

    def execute(self, context):
        names = [entry.name for entry in self.files if entry.name]
        paths = [os.path.join(self.directory, name) for name in names] or [self.filepath]
        unit_m = context.scene.unit_settings.scale_length
        made = []
        for path in paths:
            try:
                made.append(import_profile(os.path.abspath(path), self.size, context.scene.cursor.location, unit_m))
            except tool.ToolError as error:
                # One dialog for each file, in the tool's sentences.
                self.report({"ERROR"}, str(error))
        if not made:
            return {"CANCELLED"}
        for thing in context.selected_objects:
            thing.select_set(False)
        for thing in made:
            thing.select_set(True)
        context.view_layer.objects.active = made[-1]
        return {"FINISHED"}


def menu(self, context):
    self.layout.operator(ImportPhotometricLight.bl_idname, text="Photometric light (.ies .ldt .xml)")


def register():
    bpy.utils.register_class(ImportPhotometricLight)
    bpy.types.TOPBAR_MT_file_import.append(menu)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(menu)
    bpy.utils.unregister_class(ImportPhotometricLight)
