"""Makes aips a render engine of Blender: export, F12 by lxsrender, preview, panels."""
bl_info = {
    'name': 'aips',
    'description': 'Renders by lxsrender: photons guided to what the camera sees',
    'version': (1, 0, 0),
    'blender': (3, 4, 0),
    'category': 'Render',
    'location': 'Render properties > Render Engine; File > Export > LuxRender scene',
}


def _modules():
    try:
        import numpy  # noqa: F401
    except ImportError as error:
        raise ImportError('aips needs numpy in the Python of Blender: install python3-numpy, or '
                          "Blender as its makers pack it") from error
    from . import engine, export_operator, panels, preferences, settings
    return preferences, settings, engine, export_operator, panels


def register():
    for module in _modules():
        module.register()


def unregister():
    for module in reversed(_modules()):
        module.unregister()
