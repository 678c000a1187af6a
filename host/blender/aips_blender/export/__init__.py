"""The export: from Blender's evaluated scene to LuxRender 1.x files that lxsrender reads."""
