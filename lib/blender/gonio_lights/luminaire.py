"""An imported luminaire: its lumens and its colour temperature, kept in step with the lights that it is made of."""

import bpy

from . import tool


def lights_of(root):
    """The lights of an imported luminaire: its own, or those of its faces."""
    things = [root, *root.children]
    return [thing.data for thing in things if thing.type == "LIGHT"]


def show_amount(settings, context):
    """Watts for the lumens: those of the import, times the ratio to the measured flux."""
    if settings.measured_lm <= 0.0:
        return
    for light in lights_of(settings.id_data):
        light.energy = light.get("gonio_watts", light.energy) * settings.lumens / settings.measured_lm


def show_color(settings, context):
    """The colour temperature as linear Rec.709 of luminance 1, so that the lumens stay."""
    rgb = (1.0, 1.0, 1.0)
    settings.problem = ""
    if settings.has_kelvin:
        try:
            rgb = tool.run_json("cct", f"{settings.kelvin:.6g}K")["rgb"]
        except tool.ToolError as error:
            settings.problem = str(error).splitlines()[0]
            return
    for light in lights_of(settings.id_data):
        for node in light.node_tree.nodes:
            if node.type == "EMISSION":
                node.inputs["Color"].default_value = (*rgb, 1.0)


class Luminaire(bpy.types.PropertyGroup):
    file: bpy.props.StringProperty(name="Profile", description="The file that it was imported from", subtype="FILE_PATH")
    has_opening: bpy.props.BoolProperty(name="Luminous opening", description="Shines from its opening, not from a point")
    measured_lm: bpy.props.FloatProperty(name="Measured", description="The flux of the profile [lm]")
    lumens: bpy.props.FloatProperty(
        name="Lumens", description="The flux of the luminaire [lm]", min=0.0, soft_max=100000.0, update=show_amount
    )
    has_kelvin: bpy.props.BoolProperty(
        name="Colour", description="By its temperature; off: white (D65)", update=show_color
    )
    kelvin: bpy.props.FloatProperty(
        name="Kelvin", description="Colour temperature of a black body [K]", default=3000.0, min=1000.0, max=40000.0,
        update=show_color,
    )
    problem: bpy.props.StringProperty()


def luminaire_of(thing):
    """The object with the settings: the light itself, or the parent of a face; None for others."""
    for candidate in (thing, thing.parent if thing else None):
        if candidate is not None and candidate.gonio.file:
            return candidate
    return None


class LuminairePanel:
    bl_label = "Photometric light"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"

    @classmethod
    def poll(cls, context):
        return luminaire_of(context.object) is not None

    def draw(self, context):
        settings = luminaire_of(context.object).gonio
        column = self.layout.column()
        column.use_property_split = True
        column.prop(settings, "lumens")
        column.label(text=f"Measured: {settings.measured_lm:.6g} lm")
        column.prop(settings, "has_kelvin")
        row = column.row()
        row.enabled = settings.has_kelvin
        row.prop(settings, "kelvin")
        if settings.problem:
            column.label(text=settings.problem, icon="ERROR")
        column.label(text=bpy.path.basename(settings.file), icon="FILE")


class LuminaireObjectPanel(LuminairePanel, bpy.types.Panel):
    bl_idname = "OBJECT_PT_gonio_luminaire"
    bl_context = "object"


class LuminaireDataPanel(LuminairePanel, bpy.types.Panel):
    bl_idname = "DATA_PT_gonio_luminaire"
    bl_context = "data"


classes = (Luminaire, LuminaireObjectPanel, LuminaireDataPanel)


def register():
    for made in classes:
        bpy.utils.register_class(made)
    bpy.types.Object.gonio = bpy.props.PointerProperty(type=Luminaire)


def unregister():
    del bpy.types.Object.gonio
    for made in reversed(classes):
        bpy.utils.unregister_class(made)
