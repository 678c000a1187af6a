"""Panels in the render and view-layer properties, and those of Blender's that suit this engine."""
import bpy

ENGINE = 'AIPS'
# Common panels with these words in their names are of things that this engine has not.
NOT_OURS = ('freestyle', 'gpencil', 'hair')


class _Panel(bpy.types.Panel):
    bl_space_type = 'PROPERTIES'
    bl_region_type = 'WINDOW'
    bl_context = 'render'

    @classmethod
    def poll(cls, context):
        return context.engine == ENGINE

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        self.fill(self.layout, context.scene.aips, context)


class AIPS_PT_quality(_Panel):
    bl_label = 'Quality'

    def fill(self, layout, settings, _context):
        layout.prop(settings, 'until')
        shown = {'ERROR': ('target_error', 'longest'), 'TIME': ('seconds',), 'PASSES': ('passes',)}
        for name in shown[settings.until]:
            layout.prop(settings, name)
        layout.prop(settings, 'integrator')


class AIPS_PT_denoise(_Panel):
    bl_label = 'Denoise and explain'

    def fill(self, layout, settings, _context):
        layout.prop(settings, 'denoise')
        layout.prop(settings, 'explain')


class AIPS_PT_expert(_Panel):
    bl_label = 'Expert'
    bl_options = {'DEFAULT_CLOSED'}

    def fill(self, layout, settings, _context):
        layout.prop(settings, 'seed')
        layout.prop(settings, 'eye_depth')
        photons = layout.column()
        photons.enabled = settings.integrator != 'path'
        photons.prop(settings, 'photon_depth')
        photons.prop(settings, 'photons')
        guide = layout.column()
        guide.enabled = settings.integrator == 'aips'
        guide.prop(settings, 'guide')
        layout.prop(settings, 'update_interval')
        layout.prop(settings, 'extra')


class AIPS_PT_motion_blur(_Panel):
    bl_label = 'Motion blur'
    bl_options = {'DEFAULT_CLOSED'}

    def fill(self, layout, _settings, context):
        render = context.scene.render
        layout.prop(render, 'use_motion_blur')
        layout.prop(render, 'motion_blur_shutter')


class AIPS_PT_film(_Panel):
    bl_label = 'Film'
    bl_options = {'DEFAULT_CLOSED'}

    def fill(self, layout, _settings, context):
        layout.prop(context.scene.render, 'film_transparent', text='Transparent')
        cycles = getattr(context.scene, 'cycles', None)  # none where its add-on is off
        if cycles is not None:
            layout.prop(cycles, 'film_exposure', text='Exposure')
            layout.prop(cycles, 'filter_width', text='Width of the filter')


class AIPS_PT_passes(_Panel):
    bl_label = 'Passes of aips'
    bl_context = 'view_layer'

    def fill(self, layout, settings, _context):
        layout.column().prop(settings, 'layers', expand=False)


class AIPS_PT_masks(_Panel):
    bl_label = 'Masks (Cryptomatte)'
    bl_context = 'view_layer'

    def fill(self, layout, _settings, context):
        view_layer = context.view_layer
        layout.prop(view_layer, 'use_pass_cryptomatte_object', text='Objects')
        layout.prop(view_layer, 'use_pass_cryptomatte_material', text='Materials')
        layout.prop(view_layer, 'pass_cryptomatte_depth', text='Levels')


class AIPS_PT_light_groups(_Panel):
    bl_label = 'Light groups'
    bl_context = 'view_layer'

    def fill(self, layout, _settings, context):
        view_layer = context.view_layer
        row = layout.row()
        row.template_list('UI_UL_list', 'lightgroups', view_layer, 'lightgroups', view_layer,
                          'active_lightgroup_index', rows=2)
        column = row.column(align=True)
        column.operator('scene.view_layer_add_lightgroup', icon='ADD', text='')
        column.operator('scene.view_layer_remove_lightgroup', icon='REMOVE', text='')


class AIPS_PT_object_light_group(_Panel):
    bl_label = 'Light group'
    bl_context = 'object'

    def fill(self, layout, _settings, context):
        layout.prop_search(context.object, 'lightgroup', context.view_layer, 'lightgroups',
                           text='Light group')


class AIPS_PT_light_visibility(_Panel):
    bl_label = 'Visibility of the light'
    bl_context = 'object'

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.object is not None \
            and context.object.type == 'LIGHT'

    def fill(self, layout, _settings, context):
        layout.prop(context.object, 'visible_camera', text='Seen by the camera')


class AIPS_PT_world_light_group(_Panel):
    bl_label = 'Light group'
    bl_context = 'world'

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.world is not None

    def fill(self, layout, _settings, context):
        layout.prop_search(context.world, 'lightgroup', context.view_layer, 'lightgroups',
                           text='Light group')


PANELS = (AIPS_PT_quality, AIPS_PT_denoise, AIPS_PT_motion_blur, AIPS_PT_film,
          AIPS_PT_expert, AIPS_PT_passes, AIPS_PT_masks, AIPS_PT_light_groups,
          AIPS_PT_object_light_group, AIPS_PT_light_visibility, AIPS_PT_world_light_group)


# Eevee's panels of a surface's, a lamp's, the world's and the camera's own settings; what they show
# is Blender's, not Eevee's.
FROM_EEVEE = ('EEVEE_MATERIAL_PT_context_material', 'EEVEE_MATERIAL_PT_surface',
              'EEVEE_WORLD_PT_surface', 'DATA_PT_EEVEE_light', 'DATA_PT_spot', 'DATA_PT_camera_dof',
              'DATA_PT_camera_dof_aperture')


def _common_panels():
    """Blender's panels that are meant for all renderers."""
    return [panel for panel in bpy.types.Panel.__subclasses__()
            if 'BLENDER_RENDER' in getattr(panel, 'COMPAT_ENGINES', ())
            and not any(word in panel.__name__ for word in NOT_OURS)]


def _panels_of_blender():
    chosen = [getattr(bpy.types, name) for name in FROM_EEVEE if hasattr(bpy.types, name)]
    return _common_panels() + chosen


def register():
    for panel in PANELS:
        bpy.utils.register_class(panel)
    for panel in _panels_of_blender():
        panel.COMPAT_ENGINES.add(ENGINE)


def unregister():
    for panel in _panels_of_blender():
        panel.COMPAT_ENGINES.discard(ENGINE)
    for panel in reversed(PANELS):
        bpy.utils.unregister_class(panel)
