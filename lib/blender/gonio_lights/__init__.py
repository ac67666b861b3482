"""Photometric lights in Blender: measured profiles in, rigs out, lumens and kelvin in the panel. Needs the tool gonio."""

bl_info = {
    "name": "Photometric lights (gonio)",
    "author": "gonio maintainers",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > Photometric light, File > Export > Photometric rig",
    "description": "Measured IES, EULUMDAT and TM-33 profiles as lights for Cycles, and a scene's lights as a rig",
    "category": "Import-Export",
}

from . import exporter, importer, luminaire, tool

parts = (tool, luminaire, importer, exporter)


def register():
    for part in parts:
        part.register()


def unregister():
    for part in reversed(parts):
        part.unregister()
