"""The command-line tool, which does all that is photometry here."""

import json
import os
import shutil
import subprocess

import bpy

package = __package__


class ToolError(Exception):
    """What the tool said, in its own sentences; the first line is the error."""


class Preferences(bpy.types.AddonPreferences):
    bl_idname = package

    path: bpy.props.StringProperty(
        name="gonio",
        description="The command-line tool; empty: the one that the system finds",
        subtype="FILE_PATH",
    )

    def draw(self, context):
        self.layout.prop(self, "path")
        try:
            self.layout.label(text=run("--version").strip(), icon="CHECKMARK")
        except ToolError as error:
            self.layout.label(text=str(error).splitlines()[0], icon="ERROR")


def program():
    addon = bpy.context.preferences.addons.get(package)
    named = addon.preferences.path if addon else ""
    if named:
        return bpy.path.abspath(named)
    found = shutil.which("gonio")
    if not found:
        raise ToolError("the tool gonio is not installed; install it, or name it in the preferences of this add-on")
    return found


def run(*arguments, folder=None):
    """What the tool prints on stdout. Raises ToolError with what it says on stderr if it fails."""
    path = program()
    try:
        done = subprocess.run([path, *arguments], capture_output=True, cwd=folder, check=False)
    except OSError as error:
        raise ToolError(f"{path}: cannot be run: {error.strerror}") from None
    if done.returncode != 0:
        said = done.stderr.decode("utf-8", "replace").strip()
        raise ToolError(said or f"{os.path.basename(path)} ended with status {done.returncode}")
    return done.stdout.decode("utf-8", "replace")


def run_json(*arguments, folder=None):
    return json.loads(run(*arguments, "--json", folder=folder))


def register():
    bpy.utils.register_class(Preferences)


def unregister():
    bpy.utils.unregister_class(Preferences)
